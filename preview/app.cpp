#include "preview/app.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/look_slot.h"
#include "preview/opening.h"
#include "preview/overlay.h"
#include "preview/present.h"
#include "preview/ui/commands.h"
#include "preview/ui/input.h"
#include "preview/ui/look_baker.h"
#include "preview/window.h"
#include "preview/window_frame.h"

#include <GLFW/glfw3.h>

#include <fmt/format.h>
#include <imgui.h>

namespace preview {

namespace {

// Dear ImGui needs a frame to notice an event, and one to show what it led to.
constexpr int frames_after_event = 3;
constexpr int frames_in_flight = 2;

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
    void show(Shown shown);
    void resize_if_asked();
    void frame(const std::vector<ui::InputEvent>& events);
    void request_looks();
    void take_looks();
    void render(const ui::Rect& area);
    vk::Rect2D output_area(const ui::Rect& area) const;
    void write_places() const;

    Options options_;
    Window window_;
    gpu::Device device_;
    gpu::Swapchain swapchain_;
    Executor executor_;
    Shown shown_;
    std::array<LookSlot, 2> looks_;
    ui::InputQueue input_;
    ui::Ui ui_;
    ui::LookRequest requested_;
    bool baking_ = false;
    ui::LookBaker baker_;
    std::optional<Overlay> overlay_;
    FrameReader reader_{frames_in_flight};
    std::optional<Graph>
        drawn_; ///< of the last frame; none when its inputs have been written since
    int frames_due_ = frames_after_event;
    bool resize_ = true;
};

App::App(const Options& options)
    : options_(options), window_(window_size(options)), device_(window_.device_options(options)),
      swapchain_(device_, window_.make_surface(device_)),
      executor_(device_, frames_in_flight), looks_{LookSlot(device_), LookSlot(device_)},
      ui_(ui::initial_state()), baker_([] { glfwPostEmptyEvent(); }) {
    set_callbacks();
    overlay_.emplace(device_, window_.handle(), swapchain_.format(), layout_path());
    if (!overlay_->notice().empty())
        ui_.errors.push_back(overlay_->notice());
    ui_.facts.device = device_.name();

    show(load_shown(device_, options.input, options.seconds));
    ui_.history = ui::History(opening_state(shown_, options));
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

void App::show(Shown shown) {
    device_.vk().waitIdle();
    shown_ = std::move(shown);
    drawn_.reset();
    reader_.forget();
    take_shown(ui_.history.draft(), shown_, options_);
    ui_.facts.input = shown_.name;
    ui_.facts.is_scene = shown_.scene.has_value();
    ui_.facts.aspect = shown_.picture ? static_cast<float>(shown_.picture_size.width) /
                                            static_cast<float>(shown_.picture_size.height)
                                      : 0.0F;
    ui_.facts.display_encoded = shown_.display_encoded();
}

void App::open(const std::string& path) {
    if (ui::is_look_file(path))
        ui::open_look(ui_.history.draft(), path);
    else
        show(load_shown(device_, path, 0));
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
        frame(events);
    }
    for (const std::string& message : device_.validation_messages())
        std::fprintf(stderr, "lutpreview: %s\n", message.c_str());
}

void App::resize_if_asked() {
    if (!resize_)
        return;
    const Size size = window_.framebuffer_size();
    swapchain_.resize(size.width, size.height);
    overlay_->set_targets(swapchain_);
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
    overlay_->begin_frame(events);
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
    for (std::size_t i = 0; i < looks_.size(); ++i)
        looks_[i].set(baked->sides[i]);
    drawn_.reset();
}

/// The picture's part of the window, in its pixels.
vk::Rect2D App::output_area(const ui::Rect& area) const {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const vk::Extent2D window = swapchain_.extent();
    const auto x = std::min(static_cast<std::uint32_t>(area.x * scale.x), window.width - 2);
    const auto y = std::min(static_cast<std::uint32_t>(area.y * scale.y), window.height - 1);
    const auto width = std::max(static_cast<std::uint32_t>(area.width * scale.x) & ~1U, 2U);
    const auto height = std::max(static_cast<std::uint32_t>(area.height * scale.y), 1U);
    return {{static_cast<int>(x), static_cast<int>(y)},
            {std::min(width, (window.width - x) & ~1U), std::min(height, window.height - y)}};
}

void App::render(const ui::Rect& area) {
    const vk::Rect2D output = output_area(area);
    const FrameSettings settings =
        window_settings(ui_, shown_, options_, {output.extent.width, output.extent.height});
    FrameInputs inputs = shown_.inputs();
    inputs.look_a = looks_[0].look();
    inputs.look_b = looks_[1].look();
    inputs.hdr_maximum = reader_.hdr_maximum_for(settings);
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, settings);

    const std::optional<std::uint32_t> image = swapchain_.acquire();
    if (!image) {
        resize_ = true;
        frames_due_ = frames_after_event;
        return;
    }
    FrameEnd end;
    end.waits = {swapchain_.acquired()};
    end.signals = {swapchain_.finished(*image)};
    end.record = [&](const vk::raii::CommandBuffer& commands) {
        record_present(commands, executor_.image(handles.output), swapchain_.image(*image),
                       output.offset);
        overlay_->record(commands, *image);
    };
    if (drawn_ && *drawn_ == graph)
        executor_.repeat(end);
    else
        executor_.render(graph, end);
    if (!swapchain_.present(*image)) {
        resize_ = true;
        frames_due_ = frames_after_event;
    }
    reader_.read(executor_, graph, handles, ui_);
    drawn_ = std::move(graph);
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
