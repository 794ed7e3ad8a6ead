#include "preview/window/app.h"

#include "lutlib/error.h"
#include "lutlib/io/terminal.h"
#include "preview/editor/commands.h"
#include "preview/frame/frame.h"
#include "preview/panels/still_controls.h"
#include "preview/scene/import.h"
#include "preview/window/app_parts.h"
#include "preview/window/display_end.h"
#include "preview/window/opening.h"
#include "preview/window/places.h"

#include <GLFW/glfw3.h>

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace preview {

namespace {

// Bad input or a machine that cannot.
constexpr int code_of_lost_display = 2;
// What a slow machine does not draw is left out beyond this: the scene plays slower.
constexpr double longest_step = 0.5;

/// The row of engine_lookups() that side B is for.
std::size_t export_engine_of(const editor::State& state) {
    const std::vector<const GpuLookup*> rows = editor::engine_lookups();
    return static_cast<std::size_t>(std::find(rows.begin(), rows.end(), state.sides[1].engine) -
                                    rows.begin());
}

} // namespace

App::~App() {
    at_end_of_display({}, code_of_lost_display);
}

App::App(WindowSetup setup)
    : setup_(std::move(setup)), memory_(memory_path()), window_(setup_.size, memory_.memory()),
      ui_(setup_.state), baker_([] { glfwPostEmptyEvent(); }),
      thumbnails_([] { glfwPostEmptyEvent(); }), opened_(setup_.opened) {
    ui_.thumbnails.draw = &Overlay::draw_thumbnails;
    ui_.display_white = setup_.display_white;
    ui_.engine_folder = setup_.engine_folder;
    ui_.export_engine = export_engine_of(ui_.history.draft());
    ui_.text_scale = memory_.memory().text_scale;
    ui_.wake = [] { glfwPostEmptyEvent(); };
    ui_.cameras.take_others = [this] {
        if (kept_cameras_.is_outdated()) {
            take_cameras();
        }
    };
    for (const DebugView& view : debug_views()) {
        ui_.facts.debug_views.push_back({view.name, view.help});
    }
    ui_.panels_width = memory_.memory().panels_width;
    ui_.recent = memory_.memory().recent;
    ui_.look_strip.is_open = memory_.memory().has_strip;
    ui_.look_strip.folder = memory_.memory().strip_folder;
    gui_.emplace(window_.handle(), layout_path(), setup_.font);
    gui_->set_scale(window_.content_scale() * ui_.text_scale);
    for (const std::string& notice : {gui_->notice(), memory_.notice()}) {
        if (!notice.empty()) {
            ui_.errors.add(notice);
        }
    }
    if (editor::settings_folder().empty()) {
        tell("name a folder in XDG_CONFIG_HOME or HOME: without one an unsaved look is not kept "
             "when the window ends, and neither cameras nor the panels' places are remembered");
    }
    ui_.left_behind = autosave_.found();
    for (const std::string& path : ui_.left_behind) {
        lutlib::io::print_err("lutpreview: a window ended before its look was saved; this one "
                              "offers it: " +
                              lutlib::io::shown_text(path) + "\n");
    }
    at_end_of_display(
        [this] {
            keep_look();
            lutlib::io::print_err("lutpreview: the display server has ended" + where_kept() + "\n");
        },
        code_of_lost_display);
    make_screen();
}

void App::make_screen() {
    if (screen_) {
        print_validation(screen_->device);
    }
    screen_.reset();
    drawn_.reset();
    thumbnails_.forget_pictures(ui_);
    screen_.emplace(window_, window_.device_options(setup_.device, setup_.validation));
    ui_.facts.device = screen_->device.name();
    events_.resized = true;
    baking_ = false; // the new screen has no looks
    follow_shown();
}

void App::open(const std::string& path) {
    editor::State& state = ui_.history.draft();
    if (!is_model_file(path) && scene_named(path) == nullptr) {
        if (const auto look = lutlib::io::Look::open_if_look(path)) {
            editor::open_look(state, *look);
            editor::remember_file(ui_.recent, path);
            return;
        }
    }
    take_shown(state, std::make_shared<const Shown>(load_shown(path, 0)));
    follow_shown();
    if (!state.shown->files.empty()) {
        editor::remember_file(ui_.recent, path);
    }
}

/// The scene among what the picture that was chosen shows; a step of undo.
void App::surround() {
    const std::string path = std::exchange(ui_.surround_with, {});
    if (path.empty()) {
        return;
    }
    panels::attempt(ui_, [&] {
        editor::State& state = ui_.history.draft();
        Shown named;
        named.name = state.shown->name;
        named.seconds = ui_.seconds;
        named.surroundings_file = path;
        take_shown_again(state, std::make_shared<const Shown>(load_again(named)));
        state.surroundings.kind = SurroundingsKind::picture;
        editor::remember_file(ui_.recent, path);
    });
    follow_shown();
}

/// Opening, undoing and redoing change what the state shows.
void App::follow_shown() {
    const std::shared_ptr<const Shown>& shown = ui_.history.draft().shown;
    if (screen_->shown && screen_->shown->shown() == shown) {
        return;
    }
    screen_->show(shown);
    drawn_.reset();
    reader_.forget();
    ui_.facts.left_out = shown->left_out;
    ui_.facts.told = shown->told;
    ui_.facts.surroundings_told = told_of_surroundings(*shown);
    ui_.facts.cameras = shown->scene ? shown->scene->cameras : std::vector<NamedCamera>();
    if (ui_.facts.input != shown->name) {
        ui_.facts.input = shown->name;
        ui_.plays = false;
        take_cameras();
    }
    ui_.seconds = shown->seconds;
    ui_.facts.is_scene = shown->scene.has_value();
    ui_.facts.usual_orbit = shown->scene ? shown->scene->orbit : Orbit{};
    ui_.facts.usual_lights = shown->scene ? shown->scene->lights : std::vector<PointLight>{};
    ui_.facts.has_surroundings_picture = shown->surroundings.has_value();
    ui_.facts.picture_size = shown->picture_size();
    ui_.facts.display_encoded = shown->display_encoded();
}

/// In the window, and on standard error for who started it from there.
void App::tell(const std::string& notice) {
    ui_.errors.add(notice);
    wake(); // nothing else may ask for a frame
    lutlib::io::print_err("lutpreview: " + lutlib::io::shown_text(notice) + "\n");
}

void App::keep_look() {
    try {
        autosave_.keep(ui_.history.draft());
        keep_failure_.clear();
    } catch (const lutlib::Error& error) {
        const std::string reason = error.what();
        if (reason != keep_failure_) {
            keep_failure_ = reason;
            tell("save the look, for it cannot be kept until then: " + reason);
        }
    }
}

void App::keep_memory() {
    WindowMemory now = memory_.memory();
    if (!setup_.size) {
        window_.tell_place(now);
    }
    now.text_scale = ui_.text_scale;
    now.panels_width = ui_.panels_width;
    now.recent = ui_.recent;
    now.has_strip = ui_.look_strip.is_open;
    now.strip_folder = ui_.look_strip.folder;
    try {
        memory_.keep(now);
    } catch (const lutlib::Error& error) {
        tell(error.what());
    }
}

void App::scale_if_asked() {
    ui_.text_scale = std::clamp(ui_.text_scale, least_text_scale, most_text_scale);
    const float scale = window_.content_scale() * ui_.text_scale;
    if (scale != gui_->scale()) {
        gui_->set_scale(scale);
        screen_->overlay.take_fonts();
    }
}

void App::show_title() {
    std::string title = editor::window_title(ui_.history.draft());
    if (title != title_) {
        glfwSetWindowTitle(window_.handle(), title.c_str());
        title_ = std::move(title);
    }
}

/// The scene at the moment that the panel has, in every state that undo knows: time is no step.
void App::move_time() {
    const std::shared_ptr<const Shown> shown = ui_.history.draft().shown;
    if (ui_.plays) {
        const auto now = std::chrono::steady_clock::now();
        const double passed = std::chrono::duration<double>(now - played_at_).count();
        ui_.seconds += std::clamp(passed, 0.0, longest_step);
        played_at_ = now;
        wake();
    } else {
        played_at_ = std::chrono::steady_clock::now();
    }
    if (!shown->scene || ui_.seconds == shown->seconds) {
        return;
    }
    Shown named;
    named.name = shown->name;
    named.surroundings_file = shown->surroundings_file;
    named.seconds = ui_.seconds;
    const auto fresh = std::make_shared<const Shown>(load_again(named));
    ui_.history.change_all([&](editor::State& state) {
        if (state.shown == shown) {
            take_shown_again(state, fresh);
        }
    });
    follow_shown();
}

/// What somebody has chosen of the looks that windows left behind.
void App::take_left_behind() {
    if (const std::string taken = std::exchange(ui_.take_left, {}); !taken.empty()) {
        panels::attempt(ui_, [&] {
            editor::open_kept(ui_.history.draft(), taken);
            autosave_.adopt(taken);
        });
        ui_.left_behind = autosave_.found();
    }
    if (const std::string dropped = std::exchange(ui_.drop_left, {}); !dropped.empty()) {
        std::error_code failed;
        std::filesystem::remove(dropped, failed);
        if (failed) {
            ui_.errors.add("delete " + dropped + " yourself: " + failed.message());
        }
        ui_.left_behind = autosave_.found();
    }
}

/// Keeps and forgets what somebody has asked for; those of what is shown are offered.
void App::take_cameras() {
    const std::string& input = ui_.facts.input;
    try {
        if (const auto camera = std::exchange(ui_.cameras.keep, {})) {
            kept_cameras_.keep(input, *camera);
        }
        if (const std::string name = std::exchange(ui_.cameras.forget, {}); !name.empty()) {
            kept_cameras_.forget(input, name);
        }
        ui_.cameras.kept = kept_cameras_.of(input);
    } catch (const lutlib::Error& error) {
        tell(error.what());
        ui_.cameras.kept = kept_cameras_.of(input); // the window's own
    }
}

void App::resize_if_asked() {
    if (!events_.resized) {
        return;
    }
    screen_->resize(window_);
    events_.resized = false;
}

void App::frame(const std::vector<editor::InputEvent>& events) {
    resize_if_asked();
    scale_if_asked();
    std::vector<std::string> paths = std::exchange(ui_.to_open, {});
    WindowEvents::Dropped dropped = std::exchange(events_.dropped, {});
    if (!paths.empty() || !dropped.paths.empty()) {
        opened_ = Following::Clock::now();
    }
    const bool are_stills = panels::takes_dropped_stills(ui_, dropped.x, dropped.y);
    for (std::string& path : dropped.paths) {
        if (are_stills) {
            panels::attempt(ui_, [&] { panels::open_still(ui_, 0, path); });
        } else {
            paths.push_back(std::move(path));
        }
    }
    for (const std::string& path : paths) {
        panels::attempt(ui_, [&] { open(path); });
    }
    surround();
    take_left_behind();
    panels::attempt(ui_, [this] { move_time(); });
    following_.take(ui_, [this] { follow_shown(); });
    for (const editor::InputEvent& event : events) {
        if (event.kind == editor::InputEvent::Kind::key) {
            ui_.down[static_cast<std::size_t>(event.key)] = event.down;
        }
    }
    for (const editor::InputEvent& event : events) {
        if (event.kind == editor::InputEvent::Kind::key && event.down && !event.repeats) {
            ui_.pressed.push_back({event.key, event.held.ctrl, event.held.shift});
        }
    }
    follow_shown();
    following_.follow(ui_, std::exchange(opened_, Following::Clock::now()));
    screen_->overlay.begin_frame();
    gui_->begin_frame(events);
    const panels::Rect area = panels::draw(ui_);
    ImGui::Render();
    if (!ImGui::IsAnyItemActive()) {
        ui_.history.settle();
    }
    if (ui_.cameras.asks()) {
        take_cameras();
    }
    request_looks();
    take_looks();
    take_stills();
    if (const std::string to = std::exchange(ui_.save_picture_to, {}); !to.empty()) {
        panels::attempt(ui_, [&] { save_picture(to); });
        wake();
    }
    if (const auto metering = std::exchange(ui_.metering, {})) {
        meter(metering->place);
    }
    thumbnails_.take(ui_);
    render(area);
    draw_thumbnail();
    show_title();
    if ((frames_due_ == 0 || ui_.plays) && !baker_.is_busy()) {
        keep_look();
        keep_memory();
        write_places(ui_, setup_.places);
    }
}

void run_window(WindowSetup setup) {
    App app(std::move(setup));
    app.run();
}

} // namespace preview
