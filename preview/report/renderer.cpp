#include "preview/report/renderer.h"

#include "lutlib/error.h"
#include "lutlib/half.h"
#include "preview/frame/measured.h"
#include "preview/gpu/memory.h"
#include "preview/passes/pass.h"

#include <algorithm>
#include <chrono>
#include <cstring>

namespace preview::report {

namespace {

using reference::Image;

/// Frames of each situation before the first that counts; a GPU takes its time to raise its clocks.
constexpr int warm_up = 3;
constexpr std::chrono::milliseconds settling{300};

double channel_at(const std::vector<std::byte>& bytes, std::size_t index, Format format) {
    if (format == Format::rgba16f) {
        std::uint16_t half = 0;
        std::memcpy(&half, bytes.data() + index * sizeof half, sizeof half);
        return static_cast<double>(lutlib::float_from_half(half));
    }
    float value = 0;
    std::memcpy(&value, bytes.data() + index * sizeof value, sizeof value);
    return static_cast<double>(value);
}

/// Of floats or halves; one channel stands for all three.
Image image_of(const std::vector<std::byte>& bytes, const ImageDesc& desc) {
    const bool is_half = desc.format == Format::rgba16f;
    const bool has_colors = is_half || desc.format == Format::rgba32f;
    if (!has_colors && desc.format != Format::r32f) {
        throw std::logic_error("a report compares images of floats");
    }
    Image out(static_cast<int>(desc.width), static_cast<int>(desc.height));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = channel_at(bytes, has_colors ? 4 * i + c : i, desc.format);
        }
    }
    return out;
}

std::vector<float> floats_of(const std::vector<std::byte>& bytes) {
    std::vector<float> out(bytes.size() / sizeof(float));
    std::memcpy(out.data(), bytes.data(), out.size() * sizeof(float));
    return out;
}

Frame frame_of(Executor& executor, const Graph& graph, const FrameHandles& handles,
               ImageHandle result, const Looked& looked) {
    const auto read = [&](ImageHandle image) {
        return image_of(executor.read_image(image), graph.image_desc(image));
    };
    Frame out;
    out.finished = read(handles.output);
    if (result) {
        out.result = read(result);
    } else if (looked.result == nullptr) {
        out.result = out.finished;
    }
    if (looked.light) {
        out.light = read(handles.hdr);
    }
    if (looked.depth && handles.surfaces.depth) {
        out.depth = floats_of(executor.read_image(handles.surfaces.depth));
    }
    return out;
}

double seconds_of(Executor& executor, Counts counts) {
    double sum = 0;
    for (const StepTime& step : executor.timings()) {
        sum += counts(step.name) ? step.milliseconds * 1e-3 : 0;
    }
    return sum;
}

bool every_pass(std::string_view) {
    return true;
}

std::uint64_t bytes_moved(const Graph& graph, const Plan& plan) {
    std::uint64_t bytes = 0;
    for (const Step& step : plan.steps) {
        for (const Use& use : graph.passes()[step.pass].uses) {
            const bool is_used = use.version != Version::none && plan.version_lives[use.version];
            if (is_used && graph.resource_of(use.version).kind == ResourceKind::image) {
                bytes += graph.resource_of(use.version).image.bytes();
            }
        }
    }
    return bytes;
}

bool is_software(const gpu::Device& device) {
    return device.physical().getProperties().deviceType == vk::PhysicalDeviceType::eCpu;
}

} // namespace

Renderer::Renderer(const gpu::Device& device)
    : device_(device), is_cpu_(is_software(device)), executor_(device) {
    const auto families = device.physical().getQueueFamilyProperties();
    if (families[device.queue_family()].timestampValidBits == 0) {
        throw lutlib::Error("this device cannot time passes, as it has no timestamps: name another "
                            "with --device");
    }
}

bool Renderer::can_store(Format format) const {
    using Feature = vk::FormatFeatureFlagBits;
    const vk::FormatFeatureFlags wanted =
        Feature::eStorageImage | Feature::eSampledImage | Feature::eSampledImageFilterLinear;
    const auto has =
        device_.physical().getFormatProperties(gpu::vk_format(format)).optimalTilingFeatures;
    return (has & wanted) == wanted;
}

FrameInputs Renderer::inputs_of(const Situation& situation) {
    auto found =
        std::find_if(shown_.begin(), shown_.end(), [&](const std::unique_ptr<GpuShown>& it) {
            return it->shown() == situation.shown;
        });
    if (found == shown_.end()) {
        shown_.push_back(std::make_unique<GpuShown>(device_, situation.shown));
        found = std::prev(shown_.end());
    }
    FrameInputs out = (*found)->inputs();
    if (situation.has_scene()) {
        out.lights = &situation.lights;
        out.surroundings = &situation.surroundings;
    }
    out.look_a = situation.look_a;
    out.look_b = situation.look_b;
    return out;
}

Frame Renderer::render(const Situation& situation, const Looked& looked) {
    FrameSettings settings = situation.settings;
    settings.forced_keeps_maps = true;
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs_of(situation), settings);
    const ImageHandle result =
        looked.result != nullptr ? looked.result(graph, handles) : ImageHandle{};
    if (result) {
        graph.present(result);
    }
    if (looked.light) {
        graph.present(handles.hdr);
    }
    if (looked.depth && handles.surfaces.depth) {
        graph.present(handles.surfaces.depth);
    }
    executor_.render(graph);
    return frame_of(executor_, graph, handles, result, looked);
}

FrameInputs Renderer::measured(const Situation& situation) {
    FrameInputs inputs = inputs_of(situation);
    inputs.hdr_maximum = measured_maximum(executor_, inputs, situation.settings);
    return inputs;
}

Frame Renderer::render_as_usual(const Situation& situation) {
    const FrameInputs inputs = measured(situation);
    for (int frame = 0;; ++frame) {
        Graph graph;
        const FrameHandles handles = build_frame(graph, inputs, situation.settings);
        executor_.render(graph);
        if (frame == 1) {
            return frame_of(executor_, graph, handles, {}, {});
        }
    }
}

std::pair<Costs, Image> Renderer::costs_of(const Situation& situation, int rounds) {
    const FrameInputs inputs = measured(situation);
    Graph graph;
    const FrameHandles handles = build_frame(graph, inputs, situation.settings);
    for (int frame = 0; frame < warm_up; ++frame) {
        executor_.render(graph);
    }
    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round) {
        executor_.render(graph);
        seconds.push_back(seconds_of(executor_, every_pass));
    }
    Costs out;
    out.time = lutlib::timing_of(std::move(seconds));
    out.passes = executor_.plan().steps.size();
    out.bytes = bytes_moved(graph, executor_.plan());
    out.memory = executor_.pool_bytes();
    return {std::move(out), frame_of(executor_, graph, handles, {}, {}).finished};
}

void Renderer::forget() {
    executor_.wait();
    shown_.clear();
}

std::vector<lutlib::Timing> Renderer::time(std::span<const Situation> situations, Counts counts,
                                           int rounds) {
    std::vector<Graph> graphs(situations.size());
    for (std::size_t i = 0; i < situations.size(); ++i) {
        build_frame(graphs[i], inputs_of(situations[i]), situations[i].settings);
    }
    std::vector<std::vector<double>> seconds(graphs.size());
    // A GPU lowers its clocks while pipelines are made.
    const auto settled =
        std::chrono::steady_clock::now() + (is_cpu_ ? std::chrono::milliseconds(0) : settling);
    do {
        for (const Graph& graph : graphs) {
            executor_.render(graph);
            executor_.wait();
        }
    } while (std::chrono::steady_clock::now() < settled);
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < graphs.size(); ++i) {
            executor_.render(graphs[i]); // others have filled the caches
            executor_.wait();
            executor_.render(graphs[i]);
            seconds[i].push_back(seconds_of(executor_, counts));
        }
    }
    std::vector<lutlib::Timing> out;
    for (std::vector<double>& each : seconds) {
        out.push_back(lutlib::timing_of(std::move(each)));
    }
    return out;
}

} // namespace preview::report
