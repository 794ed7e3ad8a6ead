#include "preview/app.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/look_slot.h"
#include "preview/opening.h"
#include "preview/overlay.h"
#include "preview/present.h"
#include "preview/ui/commands.h"
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
    void frame();
    void request_looks();
    void take_looks();
    void render(const ui::Rect& area);
    Size output_size(const ui::Rect& area) const;
    void write_places() const;

    Options options_;
    Window window_;
    gpu::Device device_;
    gpu::Swapchain swapchain_;
    Executor executor_;
    Shown shown_;
    std::array<LookSlot, 2> looks_;
    ui::Ui ui_;
    ui::LookRequest requested_;
    bool baking_ = false;
    ui::LookBaker baker_;
    std::optional<Overlay> overlay_;
    FrameReader reader_{frames_in_flight};
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
    glfwSetFramebufferSizeCallback(window_.handle(),
                                   [](GLFWwindow* window, int, int) { of(window).resize_ = true; });
    // Dear ImGui calls these after its own.
    glfwSetCursorPosCallback(window_.handle(), [](GLFWwindow* w, double, double) { of(w).wake(); });
    glfwSetMouseButtonCallback(window_.handle(),
                               [](GLFWwindow* w, int, int, int) { of(w).wake(); });
    glfwSetScrollCallback(window_.handle(), [](GLFWwindow* w, double, double) { of(w).wake(); });
    glfwSetKeyCallback(window_.handle(), [](GLFWwindow* w, int key, int, int action, int mods) {
        of(w).wake();
        if (action == GLFW_PRESS)
            of(w).ui_.pressed.push_back(
                {key, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0});
    });
    glfwSetCharCallback(window_.handle(), [](GLFWwindow* w, unsigned) { of(w).wake(); });
    glfwSetDropCallback(window_.handle(), [](GLFWwindow* window, int count, const char** paths) {
        of(window).wake();
        for (int i = 0; i < count; ++i)
            of(window).ui_.to_open.emplace_back(paths[i]);
    });
}

void App::show(Shown shown) {
    device_.vk().waitIdle();
    shown_ = std::move(shown);
    reader_.forget();
    take_shown(ui_.history.draft(), shown_, options_);
    ui_.facts.input = shown_.name;
    ui_.facts.is_scene = shown_.scene.has_value();
    ui_.facts.display_encoded = shown_.display_encoded();
}

void App::open(const std::string& path) {
    if (ui::is_look_file(path))
        ui::open_look(ui_.history.draft(), path);
    else
        show(load_shown(device_, path, 0));
}

void App::run() {
    while (glfwWindowShouldClose(window_.handle()) == GLFW_FALSE) {
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
        --frames_due_;
        frame();
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

void App::frame() {
    resize_if_asked();
    for (const std::string& path : std::exchange(ui_.to_open, {}))
        ui::attempt(ui_, [&] { open(path); });
    overlay_->begin_frame();
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
}

Size App::output_size(const ui::Rect& area) const {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const Size wanted{std::max(static_cast<std::uint32_t>(area.width * scale.x), 2U),
                      std::max(static_cast<std::uint32_t>(area.height * scale.y), 1U)};
    return {std::min(wanted.width & ~1U, swapchain_.extent().width),
            std::min(wanted.height, swapchain_.extent().height)};
}

void App::render(const ui::Rect& area) {
    const FrameSettings settings = window_settings(ui_, shown_, options_, output_size(area));
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
        record_present(commands, executor_.image(handles.output), swapchain_.image(*image));
        overlay_->record(commands, *image);
    };
    executor_.render(graph, end);
    if (!swapchain_.present(*image)) {
        resize_ = true;
        frames_due_ = frames_after_event;
    }
    reader_.read(executor_, graph, handles, ui_);
}

void App::write_places() const {
    if (options_.places.empty())
        return;
    std::string text = fmt::format("frame {} 0 0 0\n", ImGui::GetFrameCount());
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
