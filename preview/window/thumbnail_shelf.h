// What the window knows of the small pictures that its panels ask for: which looks are read and
// which scenes are built for them (by a thread of its own), which are drawn, and when that is due
// again.
//
// A picture is due when its look, or what is shown, has changed since it was drawn; of a scene that
// is not shown, once. One is drawn in a frame, while nobody drags anything, of what is shown while
// it does not play; pictures that are not seen are not due.
#pragma once

#include "preview/editor/look_reader.h"
#include "preview/panels/ui.h"
#include "preview/window/screen.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace preview {

class ThumbnailShelf {
  public:
    /// `wake` asks for a frame, from any thread.
    explicit ThumbnailShelf(std::function<void()> wake) : wake_(std::move(wake)) {}

    /// After the panels were drawn: takes what was read, asks for what is wanted now.
    void take(panels::Ui& ui);
    /// Draws a picture where one is due: of `inputs`, as `settings` of any size say. Whether more
    /// are due.
    bool draw(panels::Ui& ui, Screen& screen, const FrameInputs& inputs, FrameSettings settings,
              const RasterChoice& raster);
    /// Everything on the GPU is made anew.
    void forget_pictures(panels::Ui& ui);

  private:
    /// What all pictures are made from, but for their looks.
    struct Made {
        PictureSettings settings;
        Orbit orbit;
        double seconds = 0;
        std::vector<PointLight> lights;
        Surroundings surroundings;
        std::shared_ptr<const Shown> shown;
        Size size;
    };
    struct Entry {
        std::shared_ptr<const LoadedLook> look; ///< while it is seen
        std::shared_ptr<const Shown> scene;     ///< until it is drawn
        std::shared_ptr<const editor::Version> version;
        std::uint64_t ticket = 0; ///< of the reading that is awaited or was taken; 0: none
        std::uint64_t drawn = 0;  ///< what drawing_ was; 0: never, or its look has changed
        std::uint64_t seen = 0;   ///< the frame in which it was wanted last
    };

    void take_news(panels::Ui& ui);
    void ask(panels::Ui& ui);
    void forget_look(panels::Ui& ui, const panels::ThumbnailKey& key, Entry& entry);
    bool is_due(const panels::Ui& ui, const panels::ThumbnailKey& key) const;
    bool is_current(const panels::Ui& ui, const panels::ThumbnailKey& key,
                    const Entry& entry) const;
    void notice_what_is_shown(const panels::Ui& ui, const FrameSettings& settings);
    std::size_t cell_for(panels::Ui& ui, const panels::ThumbnailKey& key);
    editor::LookJob job_for(const panels::ThumbnailKey& key, const Entry& entry) const;

    std::function<void()> wake_;
    std::unique_ptr<editor::LookReader> reader_; ///< once somebody wants a picture
    std::map<panels::ThumbnailKey, Entry> entries_;
    std::optional<Made> made_;
    PictureCodes codes_;        ///< that looks were read for
    std::uint64_t drawing_ = 1; ///< goes up when made_ changes
    std::uint64_t frame_ = 0, tickets_ = 0;
};

} // namespace preview
