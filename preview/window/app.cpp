#include "preview/window/app.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/terminal.h"
#include "preview/editor/commands.h"
#include "preview/editor/look_baker.h"
#include "preview/scene/import.h"
#include "preview/window/autosave.h"
#include "preview/window/display_end.h"
#include "preview/window/following.h"
#include "preview/window/gui.h"
#include "preview/window/opening.h"
#include "preview/window/present.h"
#include "preview/window/screen.h"
#include "preview/window/settings_folder.h"
#include "preview/window/window_events.h"
#include "preview/window/window_frame.h"

#include <GLFW/glfw3.h>

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace preview {

namespace {

// Dear ImGui needs a frame to notice an event, and one to show what it led to.
constexpr int frames_after_event = 3;

// Bad input or a machine that cannot.
constexpr int code_of_lost_display = 2;

std::string shown_path(const std::filesystem::path& path) {
    return lutlib::io::shown_text(path.string());
}

/// The row of engine_lookups() that side B is for.
std::size_t export_engine_of(const editor::State& state) {
    const std::vector<const GpuLookup*> rows = editor::engine_lookups();
    return static_cast<std::size_t>(std::find(rows.begin(), rows.end(), state.sides[1].engine) -
                                    rows.begin());
}

void print_validation(const gpu::Device& device) {
    for (const std::string& message : device.validation_messages()) {
        lutlib::io::print_err("lutpreview: " + lutlib::io::shown_text(message) + "\n");
    }
}

class App {
  public:
    explicit App(WindowSetup setup);
    ~App() { at_end_of_display({}, code_of_lost_display); }
    App(const App&) = delete;
    App& operator=(const App&) = delete;
    void run();

  private:
    void wake() { frames_due_ = frames_after_event; }
    void tell(const std::string& notice);
    void open(const std::string& path);
    void make_screen();
    void follow_shown();
    void resize_if_asked();
    void frame(const std::vector<editor::InputEvent>& events);
    void request_looks();
    void take_looks();
    void render(const panels::Rect& area);
    void write_places() const;
    void keep_look();
    void show_title();

    WindowSetup setup_;
    Window window_;
    WindowEvents events_{window_.handle()};
    std::optional<Gui> gui_;
    std::optional<Screen> screen_;
    panels::Ui ui_;
    editor::LookRequest requested_;
    bool baking_ = false;
    editor::LookBaker baker_;
    Following following_;
    Following::Clock::time_point opened_; ///< before all was read that is not followed yet
    FrameReader reader_{frames_in_flight};
    /// Of the last frame; none when something that it reads has been written since.
    std::optional<Graph> drawn_;
    int frames_due_ = frames_after_event;
    Recovery recovery_;
    Autosave autosave_{settings_folder()};
    bool shows_unsaved_ = false; ///< in the window's title
};

App::App(WindowSetup setup)
    : setup_(std::move(setup)), window_(setup_.size), ui_(setup_.state),
      baker_([] { glfwPostEmptyEvent(); }), opened_(setup_.opened) {
    ui_.engine_folder = setup_.engine_folder;
    ui_.export_engine = export_engine_of(ui_.history.draft());
    gui_.emplace(window_.handle(), layout_path(), setup_.font);
    if (!gui_->notice().empty()) {
        ui_.errors.push_back(gui_->notice());
    }
    if (settings_folder().empty()) {
        tell("name a folder in XDG_CONFIG_HOME or HOME: without one an unsaved look is not kept "
             "when "
             "the window ends, and the panels' places are not remembered");
    }
    for (const std::string& found : autosave_.found()) {
        tell(found);
    }
    at_end_of_display(
        [this] {
            keep_look();
            lutlib::io::print_err("lutpreview: the display server has ended" +
                                  (autosave_.kept()
                                       ? "; the unsaved look is in " + shown_path(*autosave_.kept())
                                       : std::string()) +
                                  "\n");
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
    screen_.emplace(window_, window_.device_options(setup_.device, setup_.validation));
    ui_.facts.device = screen_->device.name();
    events_.resized = true;
    baking_ = false; // the new screen has no looks
    follow_shown();
}

void App::open(const std::string& path) {
    editor::State& state = ui_.history.draft();
    if (!is_model_file(path)) {
        if (const auto look = lutlib::io::Look::open_if_look(path)) {
            editor::open_look(state, *look);
            return;
        }
    }
    take_shown(state, std::make_shared<const Shown>(load_shown(path, 0)));
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
    ui_.facts.input = shown->name;
    ui_.facts.left_out = shown->left_out;
    ui_.facts.is_scene = shown->scene.has_value();
    ui_.facts.has_surroundings_picture = shown->surroundings.has_value();
    ui_.facts.aspect = shown->picture ? static_cast<float>(shown->picture->size.width) /
                                            static_cast<float>(shown->picture->size.height)
                                      : 0.0F;
    ui_.facts.display_encoded = shown->display_encoded();
}

void App::run() {
    while (glfwWindowShouldClose(window_.handle()) == GLFW_FALSE && !ui_.quits) {
        if (frames_due_ > 0) {
            glfwPollEvents();
        } else {
            glfwWaitEvents();
            frames_due_ = frames_after_event;
        }
        const Size size = window_.framebuffer_size();
        if (size.width == 0 || size.height == 0) { // minimised
            frames_due_ = 0;
            continue;
        }
        const std::vector<editor::InputEvent> events = events_.input.next_frame();
        if (!events.empty() || !events_.dropped.empty() || events_.resized) {
            wake();
        }
        --frames_due_;
        try {
            if (std::exchange(ui_.wants_new_screen, false)) {
                make_screen();
            }
            frame(events);
            recovery_.drew();
        } catch (const vk::SystemError& error) {
            if (!is_lost(error)) {
                glfwPollEvents(); // which ends the program when the display server is gone
                throw;
            }
            ui_.errors.push_back(recovery_.lost(error));
            wake();
            make_screen();
        }
    }
    autosave_.forget();
    print_validation(screen_->device);
}

/// In the window, and on standard error for who started it from there.
void App::tell(const std::string& notice) {
    ui_.errors.push_back(notice);
    lutlib::io::print_err("lutpreview: " + lutlib::io::shown_text(notice) + "\n");
}

void App::keep_look() {
    try {
        autosave_.keep(ui_.history.draft());
    } catch (const lutlib::Error& error) {
        if (std::find(ui_.errors.begin(), ui_.errors.end(), error.what()) == ui_.errors.end()) {
            ui_.errors.emplace_back(error.what());
        }
    }
}

void App::show_title() {
    const bool is_unsaved = editor::is_unsaved(ui_.history.draft());
    if (is_unsaved != shows_unsaved_) {
        glfwSetWindowTitle(window_.handle(), is_unsaved ? "* lutpreview" : "lutpreview");
        shows_unsaved_ = is_unsaved;
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
    std::vector<std::string> paths = std::exchange(ui_.to_open, {});
    for (std::string& path : std::exchange(events_.dropped, {})) {
        paths.push_back(std::move(path));
    }
    if (!paths.empty()) {
        opened_ = Following::Clock::now();
    }
    for (const std::string& path : paths) {
        panels::attempt(ui_, [&] { open(path); });
    }
    following_.take(ui_, [this] { follow_shown(); });
    for (const editor::InputEvent& event : events) {
        if (event.kind == editor::InputEvent::Kind::key) {
            ui_.down[static_cast<std::size_t>(event.key)] = event.down;
        }
    }
    for (const editor::InputEvent& event : events) {
        if (event.kind == editor::InputEvent::Kind::key && event.down && !event.repeats) {
            ui_.pressed.push_back({event.key, (event.modifiers & GLFW_MOD_CONTROL) != 0,
                                   (event.modifiers & GLFW_MOD_SHIFT) != 0});
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
    request_looks();
    take_looks();
    render(area);
    show_title();
    if (frames_due_ == 0 && !baker_.is_busy()) {
        keep_look();
        write_places();
    }
}

void App::request_looks() {
    const editor::State& state = ui_.history.draft();
    editor::LookRequest request{state.recipe, state.sides, state.picture};
    if (baking_ && editor::same(request, requested_)) {
        return;
    }
    requested_ = request;
    baking_ = true;
    baker_.request(std::move(request));
}

void App::take_looks() {
    const std::optional<editor::BakedLooks> baked = baker_.take();
    if (!baked) {
        return;
    }
    ui_.facts.bake_milliseconds = baked->milliseconds;
    frames_due_ = frames_after_event;
    if (!baked->error.empty()) {
        ui_.errors.push_back(baked->error);
        return;
    }
    for (std::size_t i = 0; i < screen_->looks.size(); ++i) {
        screen_->looks[i].set(baked->sides[i]);
        ui_.facts.look_notes[i] = baked->sides[i].note;
        ui_.facts.look_standings[i] = baked->sides[i].encodings;
        ui_.facts.tables[i] = baked->sides[i].table;
    }
    drawn_.reset();
}

void App::render(const panels::Rect& area) {
    Screen& screen = *screen_;
    const vk::Extent2D window = screen.swapchain.extent();
    const vk::Rect2D output = output_area(area, window);
    const ScopeAreas scope_places = scope_areas(ui_, window);
    FrameSettings settings =
        window_settings(ui_, setup_.frame, {output.extent.width, output.extent.height});
    settings.raster =
        setup_.raster->on(screen.device, picture_size(settings.output, *settings.compare));
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        settings.scope_sizes[i] = {scope_places[i].extent.width, scope_places[i].extent.height};
    }
    const editor::State& state = ui_.history.draft();
    FrameInputs inputs = screen.shown->inputs();
    inputs.lights = &state.lights;
    inputs.surroundings = &state.surroundings;
    inputs.look_a = screen.looks[0].look();
    inputs.look_b = screen.looks[1].look();
    const std::array names{title_of(state.sides[0]), title_of(state.sides[1])};
    inputs.names = {names[0], names[1]};
    inputs.hdr_maximum = reader_.hdr_maximum_for(settings, state.lights, state.surroundings);
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, settings);

    const std::optional<std::uint32_t> image = screen.swapchain.acquire();
    if (!image) {
        events_.resized = true;
        frames_due_ = frames_after_event;
        return;
    }
    FrameEnd end;
    end.waits = {screen.swapchain.acquired()};
    end.signals = {screen.swapchain.finished(*image)};
    end.record = [&](const vk::raii::CommandBuffer& commands) {
        std::vector<Placed> pictures{{&screen.executor.image(handles.output), output.offset}};
        for (std::size_t i = 0; i < scopes.size(); ++i) {
            if (handles.scope_pictures[i]) {
                pictures.push_back(
                    {&screen.executor.image(handles.scope_pictures[i]), scope_places[i].offset});
            }
        }
        record_present(commands, pictures, screen.swapchain.image(*image));
        screen.overlay.record(commands, *image);
    };
    if (drawn_ && *drawn_ == graph) {
        screen.executor.repeat(end);
    } else {
        screen.executor.render(graph, end);
    }
    if (!screen.swapchain.present(*image)) {
        events_.resized = true;
        frames_due_ = frames_after_event;
    }
    if (reader_.read(screen.executor, graph, handles, ui_)) {
        frames_due_ = std::max(frames_due_, 1);
    }
    drawn_ = std::move(graph);
}

void App::write_places() const {
    if (setup_.places.empty()) {
        return;
    }
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::string text = fmt::format("frame {} 0 0 0\n", ImGui::GetFrameCount());
    if (ImGui::IsMousePosValid(&mouse)) {
        text += fmt::format("mouse {:.0f} {:.0f} 0 0\n", mouse.x, mouse.y);
    }
    for (const auto& [name, place] : ui_.places) {
        text += fmt::format("{} {:.0f} {:.0f} {:.0f} {:.0f}\n", name, place.x, place.y, place.width,
                            place.height);
    }
    lutlib::io::write_file(setup_.places, text);
}

} // namespace

void run_window(WindowSetup setup) {
    App app(std::move(setup));
    app.run();
}

} // namespace preview
