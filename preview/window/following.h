// The files of what the window shows, followed on disk.
#pragma once

#include "preview/editor/file_follower.h"
#include "preview/panels/ui.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace preview {

class Following {
  public:
    using Clock = editor::FileFollower::Clock;

    /// Nothing is followed where the system tells of no changes; take() says so once.
    Following();

    /// Puts in place what has changed, then calls `show`. Where one of both fails everything stays,
    /// and the reason is among the notices until the file can be read.
    void take(panels::Ui& ui, const std::function<void()>& show);
    /// Follows what the window shows now; files that have not been followed yet were read after
    /// `opened`.
    void follow(panels::Ui& ui, Clock::time_point opened);

  private:
    /// What of a state decides which files are followed.
    struct Made {
        std::string recipe_path, base_path, base;
        bool has_base = false;
        lutlib::LookEncodings said;
        std::array<editor::Side, 2> sides;
        std::shared_ptr<const Shown> shown;
        friend bool operator==(const Made&, const Made&) = default;
    };

    void put(panels::Ui& ui, const editor::Reread& reread, const std::function<void()>& show);

    std::optional<Made> made_;                   ///< of the last frame
    std::vector<std::string> keys_;              ///< of the files that follow from it
    std::string failure_;                        ///< why nothing is followed, till that is said
    std::map<std::string, std::string> reasons_; ///< why a file's newest state is not shown
    std::optional<editor::FileFollower> follower_;
};

} // namespace preview
