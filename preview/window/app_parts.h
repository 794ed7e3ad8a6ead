// The program of the window; app.cpp has its life, app_render.cpp what it draws.
#pragma once

#include "preview/editor/kept_cameras.h"
#include "preview/editor/look_baker.h"
#include "preview/editor/settings_folder.h"
#include "preview/window/app.h"
#include "preview/window/autosave.h"
#include "preview/window/following.h"
#include "preview/window/frozen_scopes.h"
#include "preview/window/gui.h"
#include "preview/window/screen.h"
#include "preview/window/thumbnail_shelf.h"
#include "preview/window/window_events.h"
#include "preview/window/window_frame.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace preview {

/// What the validation layers have said, on standard error.
void print_validation(const gpu::Device& device);

class App {
  public:
    // Dear ImGui needs a frame to notice an event, and one to show what it led to.
    static constexpr int frames_after_event = 3;

    explicit App(WindowSetup setup);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;
    void run();

  private:
    void loop();
    void recover(const vk::SystemError& error);
    void wake() { frames_due_ = frames_after_event; }
    void tell(const std::string& notice);
    void open(const std::string& path);
    void make_screen();
    void surround();
    void follow_shown();
    void resize_if_asked();
    void frame(const std::vector<editor::InputEvent>& events);
    void request_looks();
    void take_looks();
    void take_stills();
    void render(const panels::Rect& area);
    void draw_thumbnail();
    void freeze_scopes(const FrameHandles& handles, const ScopeLevels& levels);
    FrameHandles declared(Graph& graph, const FrameInputs& inputs, FrameSettings& settings);
    void keep_look();
    /// "; the unsaved look is in PATH", or nothing.
    std::string where_kept() const;
    void keep_memory();
    void scale_if_asked();
    void show_title();
    bool ends();
    void take_left_behind();
    void take_cameras();
    void move_time();
    FrameInputs frame_inputs() const;
    void save_picture(const std::string& path);
    void meter(const std::optional<ProbePlace>& place);

    WindowSetup setup_;
    MemoryFile memory_;
    editor::KeptCameras kept_cameras_{editor::cameras_path()};
    Window window_;
    WindowEvents events_{window_.handle()};
    std::optional<Gui> gui_;
    std::optional<Screen> screen_;
    FrozenScopes frozen_;
    panels::Ui ui_;
    editor::LookRequest requested_;
    bool baking_ = false;
    editor::LookBaker baker_;
    Following following_;
    ThumbnailShelf thumbnails_;
    Following::Clock::time_point opened_; ///< before all was read that is not followed yet
    FrameReader reader_{frames_in_flight};
    /// Of the last frame; none when something that it reads has been written since.
    std::optional<Graph> drawn_;
    int frames_due_ = frames_after_event;
    Recovery recovery_;
    Autosave autosave_{editor::settings_folder()};
    std::string title_;                               ///< the window's
    std::chrono::steady_clock::time_point played_at_; ///< the last frame of a scene that plays
    std::string keep_failure_;                        ///< why the look is not kept; empty: it is
};

} // namespace preview
