#include "preview/app.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "preview/graph/execute.h"
#include "preview/look_slot.h"
#include "preview/overlay.h"
#include "preview/shown.h"
#include "preview/ui/commands.h"
#include "preview/ui/input.h"
#include "preview/ui/look_baker.h"
#include "preview/ui/ui.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

#include <fmt/format.h>
#include <imgui.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace preview {

namespace {

// Dear ImGui needs a frame to notice an event, and one to show what it led to.
constexpr int frames_after_event = 3;
constexpr int frames_in_flight = 2;

std::string glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

struct Glfw {
    Glfw() {
        if (glfwInit() != GLFW_TRUE)
            throw lutlib::Error("a window was asked for and none can be had: " + glfw_error() +
                                "; --headless -o FILE renders without one");
        if (glfwVulkanSupported() != GLFW_TRUE) {
            glfwTerminate();
            throw lutlib::Error("no Vulkan driver can draw in a window here; --headless -o FILE "
                                "renders without one");
        }
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

struct Window {
    explicit Window(Size size) {
        glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
        handle = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height),
                                  "lutpreview", nullptr, nullptr);
        if (handle == nullptr)
            throw lutlib::Error("a window was asked for and none can be had: " + glfw_error());
    }
    ~Window() { glfwDestroyWindow(handle); }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    GLFWwindow* handle = nullptr;
};

gpu::DeviceOptions device_options(const Options& options) {
    gpu::DeviceOptions out;
    out.wanted = options.device;
    out.validation = options.validate;
    std::uint32_t count = 0;
    const char** const names = glfwGetRequiredInstanceExtensions(&count);
    out.instance_extensions.assign(names, names + count);
    out.device_extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    return out;
}

VkSurfaceKHR make_surface(const gpu::Device& device, GLFWwindow* window) {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (glfwCreateWindowSurface(*device.instance(), window, nullptr, &surface) != VK_SUCCESS)
        throw lutlib::Error("no Vulkan surface can be had for the window: " + glfw_error());
    return surface;
}

/// Where the panels' layout is remembered, or empty.
std::string layout_path() {
    namespace fs = std::filesystem;
    const char* const config = std::getenv("XDG_CONFIG_HOME");
    const char* const home = std::getenv("HOME");
    if (config == nullptr && home == nullptr)
        return {};
    const fs::path folder =
        (config != nullptr ? fs::path(config) : fs::path(home) / ".config") / "lutpreview";
    std::error_code failed;
    fs::create_directories(folder, failed);
    return failed ? std::string() : (folder / "layout.ini").string();
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
    void show(Shown shown);
    void resize_if_asked();
    void frame(const std::vector<ui::InputEvent>& events);
    void request_looks();
    void take_looks();
    void render(const ui::Rect& area);
    void learn_from(const Graph& graph, const FrameSettings& settings, Size picture);
    FrameSettings settings_for(const ui::Rect& area) const;
    void write_places() const;

    Options options_;
    Glfw glfw_;
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
    FrameSettings measured_for_; ///< of the light in the newest frames
    int frames_of_light_ = 0;    ///< how many of those frames there are
    std::optional<float> hdr_maximum_;
    int frames_due_ = frames_after_event;
    bool resize_ = true;
};

Size window_size(const Options& options) {
    const Size given = settings_of(options, {}).output;
    return options.size.empty() ? Size{1600, 900} : given;
}

App::App(const Options& options)
    : options_(options), window_(window_size(options)), device_(device_options(options)),
      swapchain_(device_, make_surface(device_, window_.handle)),
      executor_(device_, frames_in_flight), looks_{LookSlot(device_), LookSlot(device_)},
      ui_(ui::initial_state()), baker_([] { glfwPostEmptyEvent(); }) {
    set_callbacks();
    overlay_.emplace(device_, window_.handle, swapchain_.format(), layout_path());
    if (!overlay_->notice().empty())
        ui_.errors.push_back(overlay_->notice());
    ui_.facts.device = device_.name();

    const FrameSettings given = settings_of(options, {});
    ui::State& state = ui_.history.draft();
    state.tonemap = given.tonemap;
    state.bloom = given.bloom;
    state.bloom_settings = given.bloom_settings;
    state.exposure = given.exposure;
    state.split = given.split;
    state.heat_scale = given.heat_scale;
    if (!options.compare.empty())
        state.compare = given.compare;
    show(load_shown(device_, options.input, options.seconds));
    if (options.fxaa_given)
        state.fxaa = options.fxaa;
    if (!options.engine.empty())
        for (const Lookup* row : ui::engine_lookups())
            if (row->name == options.engine)
                for (ui::Side& side : state.sides)
                    side.engine = row;
    if (options.look_b.empty()) {
        if (options.look_a != "none")
            ui::open_look(state, options.look_a);
    } else {
        ui::open_look(state, options.look_b);
        if (options.look_a != "none")
            ui::open_side(state.sides[0], options.look_a);
    }
    ui_.history = ui::History(state);
}

void App::set_callbacks() {
    glfwSetWindowUserPointer(window_.handle, this);
    glfwSetFramebufferSizeCallback(window_.handle,
                                   [](GLFWwindow* window, int, int) { of(window).resize_ = true; });
    using Kind = ui::InputEvent::Kind;
    glfwSetCursorPosCallback(window_.handle, [](GLFWwindow* w, double x, double y) {
        of(w).input_.push({Kind::move, static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetCursorEnterCallback(window_.handle, [](GLFWwindow* w, int entered) {
        // A drag goes on outside; its moves keep coming.
        if (entered == GLFW_FALSE && !ImGui::IsAnyMouseDown())
            of(w).input_.push({Kind::move, ui::far_away, ui::far_away});
    });
    glfwSetScrollCallback(window_.handle, [](GLFWwindow* w, double x, double y) {
        of(w).input_.push({Kind::wheel, static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetMouseButtonCallback(window_.handle, [](GLFWwindow* w, int button, int action, int) {
        of(w).input_.push({Kind::button, 0, 0, button, 0, 0, action == GLFW_PRESS});
    });
    glfwSetKeyCallback(window_.handle,
                       [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
                           of(w).input_.push({Kind::key, 0, 0, key, scancode, modifiers,
                                              action != GLFW_RELEASE, action == GLFW_REPEAT});
                       });
    glfwSetCharCallback(window_.handle, [](GLFWwindow* w, unsigned character) {
        of(w).input_.push({Kind::character, 0, 0, static_cast<int>(character)});
    });
    glfwSetDropCallback(window_.handle, [](GLFWwindow* window, int count, const char** paths) {
        of(window).wake();
        for (int i = 0; i < count; ++i)
            of(window).ui_.to_open.emplace_back(paths[i]);
    });
}

void App::show(Shown shown) {
    device_.vk().waitIdle();
    shown_ = std::move(shown);
    hdr_maximum_.reset();
    frames_of_light_ = 0;
    ui::State& state = ui_.history.draft();
    if (shown_.scene) {
        state.orbit = shown_.scene->orbit;
        state.orbit.azimuth += options_.azimuth;
        state.orbit.elevation += options_.elevation;
        state.orbit.distance += options_.distance;
        state.orbit.field_of_view += options_.field_of_view;
    }
    state.fxaa = shown_.scene.has_value();
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
    while (glfwWindowShouldClose(window_.handle) == GLFW_FALSE && !ui_.quits) {
        if (frames_due_ > 0) {
            glfwPollEvents();
        } else {
            glfwWaitEvents();
            frames_due_ = frames_after_event;
        }
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_.handle, &width, &height);
        if (width == 0 || height == 0) { // minimised
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
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_.handle, &width, &height);
    swapchain_.resize(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
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
}

FrameSettings App::settings_for(const ui::Rect& area) const {
    const ui::State& state = ui_.history.draft();
    FrameSettings settings;
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    settings.output = {std::max(static_cast<std::uint32_t>(area.width * scale.x), 2U),
                       std::max(static_cast<std::uint32_t>(area.height * scale.y), 1U)};
    settings.output.width = std::min(settings.output.width & ~1U, swapchain_.extent().width);
    settings.output.height = std::min(settings.output.height, swapchain_.extent().height);
    settings.orbit = state.orbit;
    settings.exposure = state.exposure + (shown_.scene ? shown_.scene->exposure : 0);
    settings.tonemap = shown_.display_encoded() ? nullptr : state.tonemap;
    settings.bloom = state.bloom;
    settings.bloom_settings = state.bloom_settings;
    settings.compare = ui_.held != nullptr ? ui_.held : state.compare;
    settings.split = state.split;
    settings.heat_scale = state.heat_scale;
    settings.fxaa = state.fxaa;
    settings.shadow_size = options_.shadow_size;
    settings.force_all = options_.force_all;
    return settings;
}

/// Whether both frames have the same HDR picture.
bool same_light(const FrameSettings& a, const FrameSettings& b) {
    return std::memcmp(&a.orbit, &b.orbit, sizeof a.orbit) == 0 && a.exposure == b.exposure &&
           picture_size(a.output, *a.compare) == picture_size(b.output, *b.compare);
}

void App::render(const ui::Rect& area) {
    const FrameSettings settings = settings_for(area);
    if (!same_light(settings, measured_for_)) {
        hdr_maximum_.reset();
        measured_for_ = settings;
        frames_of_light_ = 0;
    }
    FrameInputs inputs = shown_.inputs();
    inputs.look_a = looks_[0].look();
    inputs.look_b = looks_[1].look();
    inputs.hdr_maximum = hdr_maximum_;
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, settings);

    const std::optional<std::uint32_t> image = swapchain_.acquire();
    if (!image) {
        resize_ = true;
        frames_due_ = frames_after_event;
        return;
    }
    const Size size = size_of(graph, handles.output);
    FrameEnd end;
    end.waits = {swapchain_.acquired()};
    end.signals = {swapchain_.finished(*image)};
    end.record = [&](const vk::raii::CommandBuffer& commands) {
        const vk::Image target = swapchain_.image(*image);
        const vk::ImageSubresourceRange all(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
        using Stage = vk::PipelineStageFlagBits2;
        using Access = vk::AccessFlagBits2;
        constexpr auto layout = vk::ImageLayout::eTransferDstOptimal;
        const vk::ImageMemoryBarrier2 to_clear(Stage::eAllCommands, {}, Stage::eAllTransfer,
                                               Access::eTransferWrite, vk::ImageLayout::eUndefined,
                                               layout, VK_QUEUE_FAMILY_IGNORED,
                                               VK_QUEUE_FAMILY_IGNORED, target, all);
        commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, to_clear));
        commands.clearColorImage(target, layout,
                                 vk::ClearColorValue(std::array{0.F, 0.F, 0.F, 1.F}), all);
        const vk::MemoryBarrier2 to_blit(Stage::eAllTransfer, Access::eTransferWrite,
                                         Stage::eAllTransfer, Access::eTransferWrite);
        commands.pipelineBarrier2(vk::DependencyInfo({}, to_blit));
        const vk::ImageSubresourceLayers layers(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
        const vk::Offset3D zero(0, 0, 0);
        const vk::Offset3D far(static_cast<int>(size.width), static_cast<int>(size.height), 1);
        commands.blitImage(
            executor_.image(handles.output).vk(), vk::ImageLayout::eTransferSrcOptimal, target,
            layout, vk::ImageBlit(layers, {zero, far}, layers, {zero, far}), vk::Filter::eNearest);
        overlay_->record(commands, *image);
    };
    executor_.render(graph, end);
    if (!swapchain_.present(*image)) {
        resize_ = true;
        frames_due_ = frames_after_event;
    }
    learn_from(graph, settings, handles.graded ? size_of(graph, handles.graded) : size);
}

void App::learn_from(const Graph& graph, const FrameSettings& settings, Size picture) {
    ui_.facts.explanation = explain(graph, executor_.plan());
    if (ui_.shows_passes) {
        ui_.facts.passes.clear();
        for (const StepTime& step : executor_.timings())
            ui_.facts.passes.push_back({step.name, step.milliseconds});
    }
    // Once every frame in flight has this light, the newest that has finished measured it.
    if (++frames_of_light_ >= frames_in_flight && !hdr_maximum_) {
        const std::vector<std::byte> bytes = executor_.finished_buffer("hdr maximum");
        if (bytes.size() == sizeof(float)) {
            float maximum = 0;
            std::memcpy(&maximum, bytes.data(), sizeof maximum);
            hdr_maximum_ = maximum;
        }
    }
    ui_.facts.figures.reset();
    if (settings.compare == &compare_difference) {
        const std::vector<std::byte> bytes = executor_.finished_buffer("figures");
        std::vector<std::uint32_t> counted(bytes.size() / sizeof(std::uint32_t));
        std::memcpy(counted.data(), bytes.data(), counted.size() * sizeof(std::uint32_t));
        if (!counted.empty())
            ui_.facts.figures =
                difference_figures(counted, std::uint64_t{picture.width} * picture.height);
    }
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
