#include "preview/app.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/gui.h"
#include "preview/opening.h"
#include "preview/present.h"
#include "preview/scene/import.h"
#include "preview/screen.h"
#include "preview/ui/commands.h"
#include "preview/ui/input.h"
#include "preview/ui/look_baker.h"
#include "preview/window_frame.h"

#include <GLFW/glfw3.h>

#include <fmt/format.h>
#include <imgui.h>

namespace preview {

namespace {

// Dear ImGui needs a frame to notice an event, and one to show what it led to.
constexpr int frames_after_event = 3;
// A device that is lost again before so many frames were drawn will not do.
constexpr int frames_of_recovery = 10;

void print_validation(const gpu::Device& device) {
    for (const std::string& message : device.validation_messages())
        std::fprintf(stderr, "lutpreview: %s\n", message.c_str());
}

class App {
  public:
    explicit App(const Options& options);
    void run();

  private:
    static App& of(GLFWwindow* window) {
        return *static_cast<App*>(glfwGetWindowUserPointer(window));
    }
    void set_callbacks();
    void wake() { frames_due_ = frames_after_event; }
    void open(const std::string& path);
    void make_screen();
    void recover(const vk::SystemError& error);
    void follow_shown();
    void resize_if_asked();
    void frame(const std::vector<ui::InputEvent>& events);
    void request_looks();
    void take_looks();
    void render(const ui::Rect& area);
    vk::Rect2D output_area(const ui::Rect& area) const;
    void write_places() const;

    Options options_;
    Window window_;
    std::optional<Gui> gui_;
    std::optional<Screen> screen_;
    ui::InputQueue input_;
    ui::Ui ui_;
    ui::LookRequest requested_;
    bool baking_ = false;
    ui::LookBaker baker_;
    FrameReader reader_{frames_in_flight};
    int frames_due_ = frames_after_event;
    int frames_to_prove_ = 0; ///< until the screen that replaced a lost one has shown that it works
    bool resize_ = true;
};

App::App(const Options& options)
    : options_(options), window_(window_size(options)), ui_(opening_state(options)),
      baker_([] { glfwPostEmptyEvent(); }) {
    set_callbacks();
    gui_.emplace(window_.handle(), layout_path(), font_path);
    if (!gui_->notice().empty())
        ui_.errors.push_back(gui_->notice());
    make_screen();
}

void App::make_screen() {
    if (screen_)
        print_validation(screen_->device);
    screen_.reset();
    screen_.emplace(window_, options_);
    ui_.facts.device = screen_->device.name();
    resize_ = true;
    baking_ = false; // the new screen has no looks
    follow_shown();
}

void App::recover(const vk::SystemError& error) {
    if (frames_to_prove_ > 0)
        throw lutlib::Error(std::string("the GPU was lost twice: ") + error.what() +
                            "; choose another with --device, or render with --headless");
    ui_.errors.push_back(std::string("the GPU was lost and everything on it was made anew: ") +
                         error.what());
    frames_to_prove_ = frames_of_recovery;
    wake();
    make_screen();
}

void App::set_callbacks() {
    glfwSetWindowUserPointer(window_.handle(), this);
    glfwSetFramebufferSizeCallback(window_.handle(), [](GLFWwindow* window, int, int) {
        of(window).resize_ = true;
        of(window).wake();
    });
    using Kind = ui::InputEvent::Kind;
    glfwSetCursorPosCallback(window_.handle(), [](GLFWwindow* w, double x, double y) {
        of(w).input_.push({Kind::move, static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetCursorEnterCallback(window_.handle(), [](GLFWwindow* w, int entered) {
        // A drag goes on outside; its moves keep coming.
        if (entered == GLFW_FALSE && !ImGui::IsAnyMouseDown())
            of(w).input_.push({Kind::move, ui::far_away, ui::far_away});
    });
    glfwSetScrollCallback(window_.handle(), [](GLFWwindow* w, double x, double y) {
        of(w).input_.push({Kind::wheel, static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetMouseButtonCallback(window_.handle(), [](GLFWwindow* w, int button, int action, int) {
        of(w).input_.push({Kind::button, 0, 0, button, 0, 0, action == GLFW_PRESS});
    });
    glfwSetKeyCallback(window_.handle(),
                       [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
                           of(w).input_.push({Kind::key, 0, 0, key, scancode, modifiers,
                                              action != GLFW_RELEASE, action == GLFW_REPEAT});
                       });
    glfwSetCharCallback(window_.handle(), [](GLFWwindow* w, unsigned character) {
        of(w).input_.push({Kind::character, 0, 0, static_cast<int>(character)});
    });
    glfwSetDropCallback(window_.handle(), [](GLFWwindow* window, int count, const char** paths) {
        of(window).wake();
        for (int i = 0; i < count; ++i)
            of(window).ui_.to_open.emplace_back(paths[i]);
    });
}

void App::open(const std::string& path) {
    ui::State& state = ui_.history.draft();
    if (!is_model_file(path) && ui::is_look_file(path)) {
        ui::open_look(state, path);
        return;
    }
    take_shown(state, std::make_shared<const Shown>(load_shown(path, 0)));
    follow_shown();
}

/// Opening, undoing and redoing change what the state shows.
void App::follow_shown() {
    const std::shared_ptr<const Shown>& shown = ui_.history.draft().shown;
    if (screen_->shown && screen_->shown->shown() == shown)
        return;
    screen_->show(shown);
    reader_.forget();
    ui_.facts.input = shown->name;
    ui_.facts.left_out = shown->left_out;
    ui_.facts.aspect = shown->picture ? static_cast<float>(shown->picture->size.width) /
                                            static_cast<float>(shown->picture->size.height)
                                      : 0.0F;
    ui_.facts.is_scene = shown->scene.has_value();
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
        const std::vector<ui::InputEvent> events = input_.next_frame();
        if (!events.empty())
            wake();
        --frames_due_;
        try {
            if (std::exchange(ui_.wants_new_screen, false))
                make_screen();
            frame(events);
            frames_to_prove_ = std::max(frames_to_prove_ - 1, 0);
        } catch (const vk::SystemError& error) {
            if (!is_lost(error))
                throw;
            recover(error);
        }
    }
    print_validation(screen_->device);
}

void App::resize_if_asked() {
    if (!resize_)
        return;
    screen_->resize(window_);
    resize_ = false;
}

void App::frame(const std::vector<ui::InputEvent>& events) {
    resize_if_asked();
    for (const std::string& path : std::exchange(ui_.to_open, {}))
        ui::attempt(ui_, [&] { open(path); });
    for (const ui::InputEvent& event : events)
        if (event.kind == ui::InputEvent::Kind::key && event.down && !event.repeats)
            ui_.pressed.push_back({event.code, (event.modifiers & GLFW_MOD_CONTROL) != 0,
                                   (event.modifiers & GLFW_MOD_SHIFT) != 0});
    follow_shown();
    screen_->overlay.begin_frame();
    gui_->begin_frame(events);
    const ui::Rect area = ui::draw(ui_);
    ImGui::Render();
    if (!ImGui::IsAnyItemActive())
        ui_.history.settle();
    request_looks();
    take_looks();
    render(area);
    if (frames_due_ == 0 && !baker_.is_busy())
        write_places();
}

void App::request_looks() {
    const ui::State& state = ui_.history.draft();
    ui::LookRequest request{state.recipe, state.sides};
    if (baking_ && ui::same(request, requested_))
        return;
    requested_ = request;
    baking_ = true;
    baker_.request(std::move(request));
}

void App::take_looks() {
    const std::optional<ui::BakedLooks> baked = baker_.take();
    if (!baked)
        return;
    ui_.facts.bake_milliseconds = baked->milliseconds;
    frames_due_ = frames_after_event;
    if (!baked->error.empty()) {
        ui_.errors.push_back(baked->error);
        return;
    }
    for (std::size_t i = 0; i < screen_->looks.size(); ++i)
        screen_->looks[i].set(baked->sides[i]);
}

/// The picture's part of the window, in its pixels.
vk::Rect2D App::output_area(const ui::Rect& area) const {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const vk::Extent2D window = screen_->swapchain.extent();
    const auto x = std::min(static_cast<std::uint32_t>(area.x * scale.x), window.width - 2);
    const auto y = std::min(static_cast<std::uint32_t>(area.y * scale.y), window.height - 1);
    const auto width = std::max(static_cast<std::uint32_t>(area.width * scale.x) & ~1U, 2U);
    const auto height = std::max(static_cast<std::uint32_t>(area.height * scale.y), 1U);
    return {{static_cast<int>(x), static_cast<int>(y)},
            {std::min(width, (window.width - x) & ~1U), std::min(height, window.height - y)}};
}

void App::render(const ui::Rect& area) {
    Screen& screen = *screen_;
    const vk::Rect2D output = output_area(area);
    const FrameSettings settings =
        window_settings(ui_, options_, screen.device, {output.extent.width, output.extent.height});
    const std::vector<PointLight>& lights = ui_.history.draft().lights;
    FrameInputs inputs = screen.shown->inputs();
    inputs.lights = &lights;
    inputs.look_a = screen.looks[0].look();
    inputs.look_b = screen.looks[1].look();
    inputs.hdr_maximum = reader_.hdr_maximum_for(settings, lights);
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, settings);

    const std::optional<std::uint32_t> image = screen.swapchain.acquire();
    if (!image) {
        resize_ = true;
        frames_due_ = frames_after_event;
        return;
    }
    FrameEnd end;
    end.waits = {screen.swapchain.acquired()};
    end.signals = {screen.swapchain.finished(*image)};
    end.record = [&](const vk::raii::CommandBuffer& commands) {
        record_present(commands, screen.executor.image(handles.output),
                       screen.swapchain.image(*image), output.offset);
        screen.overlay.record(commands, *image);
    };
    screen.executor.render(graph, end);
    if (!screen.swapchain.present(*image)) {
        resize_ = true;
        frames_due_ = frames_after_event;
    }
    reader_.read(screen.executor, graph, handles, ui_);
}

void App::write_places() const {
    if (options_.places.empty())
        return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::string text = fmt::format("frame {} 0 0 0\n", ImGui::GetFrameCount());
    if (ImGui::IsMousePosValid(&mouse))
        text += fmt::format("mouse {:.0f} {:.0f} 0 0\n", mouse.x, mouse.y);
    for (const auto& [name, place] : ui_.places)
        text += fmt::format("{} {:.0f} {:.0f} {:.0f} {:.0f}\n", name, place.x, place.y, place.width,
                            place.height);
    lutlib::io::write_file(options_.places, text);
}

} // namespace

void run_window(const Options& options) {
    App app(options);
    app.run();
}

} // namespace preview
