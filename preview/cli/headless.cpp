#include "preview/cli/headless.h"

#include "lutlib/error.h"
#include "lutlib/half.h"
#include "lutlib/named.h"
#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "preview/frame/frame_effects.h"
#include "preview/frame/measured.h"
#include "preview/passes/pass.h"
#include "preview/scene/gpu_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <sstream>

namespace preview {

namespace {

constexpr int warm_up_frames = 5;

template <class T>
std::vector<T> values_of(const std::vector<std::byte>& bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

/// Of an intermediate that is called otherwise than what withholds it: how that begins.
struct NamedOtherwise {
    std::string_view view, withheld;
};
constexpr NamedOtherwise named_otherwise[] = {
    {"occlusion", "ambient occlusion"},
    {"shadows", "shadow of "},
    {"shadows", "light"},
    {"normal", "g-buffer"},
    {"albedo", "g-buffer"},
    {"roughness", "g-buffer"},
    {"metalness", "g-buffer"},
    {"emission", "g-buffer"},
};

/// What a person can do about a reason.
std::string remedy_of(const Withheld& item) {
    if (item.reason == "it is not in use") {
        return fmt::format("; add --effect {}", item.name);
    }
    if (item.reason == "switched off" && lutlib::find_named(effects, item.name) != nullptr) {
        return fmt::format("; drop --without {}", item.name);
    }
    const bool is_forward = item.reason == "surfaces are lit as they are drawn" ||
                            item.reason == "it needs the g-buffer";
    return is_forward ? "; drop --raster forward" : "";
}

/// build_frame(), whose refusal of what is to be shown then has the reason.
FrameHandles declare_frame(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings) {
    try {
        return build_frame(graph, inputs, settings);
    } catch (const lutlib::UsageError&) {
        const std::string name(settings.view != nullptr          ? settings.view->name
                               : settings.effect_view != nullptr ? settings.effect_view->name
                               : settings.scope != nullptr       ? settings.scope->name
                                                                 : "");
        const std::string why =
            why_not_shown(name, {graph.withheld().begin(), graph.withheld().end()});
        throw lutlib::UsageError(fmt::format("this frame has no '{}' to show: {}", name, why));
    }
}

/// The inputs with the HDR maximum measured, where the frame has one.
FrameInputs measured(Executor& executor, FrameInputs inputs, const FrameSettings& settings) {
    inputs.hdr_maximum = measured_maximum(executor, inputs, settings);
    return inputs;
}

DifferenceFigures figures_of(Executor& executor, const Graph& graph, const FrameHandles& handles) {
    const Size size = size_of(graph, handles.graded);
    return difference_figures(values_of<std::uint32_t>(executor.read_buffer(handles.figures)),
                              std::uint64_t{size.width} * size.height);
}

/// A heat map that is to end at the differences' 99th percentile, told where that is.
FrameSettings with_heat_scale(Executor& executor, const FrameInputs& inputs,
                              FrameSettings settings) {
    if (settings.heat_scale >= 0 || settings.compare != &compare_difference ||
        settings.shows_intermediate()) {
        return settings;
    }
    Graph graph;
    const FrameHandles handles = declare_frame(graph, inputs, settings);
    executor.render(graph);
    settings.heat_scale = heat_scale_for(figures_of(executor, graph, handles));
    return settings;
}

PassTiming statistics(std::string name, std::vector<double> times) {
    if (times.empty()) {
        return {std::move(name), 0, 0};
    }
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) {
        return times[std::min(static_cast<std::size_t>(share * static_cast<double>(times.size())),
                              times.size() - 1)];
    };
    return {std::move(name), at(0.5), at(0.95)};
}

nlohmann::json json_of(const PassTiming& timing) {
    return {{"name", timing.name}, {"median_ms", timing.median}, {"p95_ms", timing.p95}};
}

} // namespace

Rendered render_frame(Executor& executor, const FrameInputs& inputs, const FrameSettings& asked) {
    const FrameInputs known = measured(executor, inputs, asked);
    const FrameSettings settings = with_heat_scale(executor, known, asked);
    Graph graph;
    const FrameHandles handles = declare_frame(graph, known, settings);
    executor.render(graph);

    Rendered out;
    out.explanation = explain(graph, executor.plan()) + order_text(handles);
    out.withheld.assign(graph.withheld().begin(), graph.withheld().end());
    out.size = size_of(graph, handles.output);
    if (graph.image_desc(handles.output).format == Format::rgba32f) {
        out.values = values_of<float>(executor.read_image(handles.output));
    } else {
        out.rgba = values_of<std::uint8_t>(executor.read_image(handles.output));
    }
    if (settings.shows_intermediate()) {
        return out;
    }
    if (settings.keep_hdr) {
        out.hdr_size = size_of(graph, handles.hdr);
        for (const std::uint16_t half :
             values_of<std::uint16_t>(executor.read_image(handles.hdr))) {
            out.hdr.push_back(lutlib::float_from_half(half));
        }
    }
    if (handles.figures) {
        out.figures = figures_of(executor, graph, handles);
        out.heat_scale = settings.heat_scale;
    }
    if (settings.keeps_scopes && settings.scope != nullptr) {
        const ScopeCounts& counted = handles.scope_counts[index_of(*settings.scope)];
        out.scope_counts = values_of<std::uint32_t>(executor.read_buffer(counted.counts));
    }
    if (handles.probe) {
        out.probe = probe_from(executor.read_buffer(handles.probe));
    }
    return out;
}

std::string why_not_shown(const std::string& name, const std::vector<Withheld>& withheld) {
    std::string why;
    const auto add = [&](const Withheld& item) {
        why += why.empty() ? "" : ", ";
        why += item.name == name || item.name == "scene" ? "" : item.name + ": ";
        why += item.reason + remedy_of(item);
    };
    for (const Withheld& item : withheld) {
        const bool is_meant =
            item.name == name ||
            std::any_of(std::begin(named_otherwise), std::end(named_otherwise),
                        [&](const NamedOtherwise& row) {
                            return row.view == name && item.name.starts_with(row.withheld);
                        });
        if (is_meant) {
            add(item);
        }
    }
    for (const Withheld& item : withheld) {
        // Without a scene nothing that is made of one has a reason of its own.
        if (why.empty() && item.name == "scene") {
            add(item);
        }
    }
    return why.empty() ? "nothing in the scene makes one" : why;
}

std::vector<std::string> left_out(const std::vector<AskedPart>& asked,
                                  const std::vector<Withheld>& withheld) {
    std::vector<std::string> out;
    for (const AskedPart& part : asked) {
        const auto found =
            std::find_if(withheld.begin(), withheld.end(),
                         [&](const Withheld& item) { return item.name == part.name; });
        if (found != withheld.end()) {
            out.push_back(fmt::format("{} changes nothing here: {}", part.option, found->reason));
        }
    }
    return out;
}

Timings time_frames(Executor& executor, const FrameInputs& inputs, const FrameSettings& settings,
                    int frames) {
    FrameSettings whole = settings;
    whole.keeps_light = false;
    const FrameInputs known = measured(executor, inputs, whole);
    Timings out;
    std::vector<std::string> order;
    std::map<std::string, std::vector<double>> by_name;
    std::vector<double> gpu;
    std::vector<double> wall;
    for (int frame = 0; frame < warm_up_frames + frames; ++frame) {
        const auto start = std::chrono::steady_clock::now();
        Graph graph;
        declare_frame(graph, known, whole);
        executor.render(graph);
        executor.wait();
        const std::chrono::duration<double, std::milli> took =
            std::chrono::steady_clock::now() - start;
        if (frame < warm_up_frames) {
            out.withheld.assign(graph.withheld().begin(), graph.withheld().end());
            continue;
        }
        std::map<std::string, double> sums;
        double total = 0;
        for (const StepTime& step : executor.timings()) {
            if (by_name.find(step.name) == by_name.end()) {
                order.push_back(step.name);
                by_name[step.name];
            }
            sums[step.name] += step.milliseconds;
            total += step.milliseconds;
        }
        for (const auto& [name, milliseconds] : sums) {
            by_name[name].push_back(milliseconds);
        }
        gpu.push_back(total);
        wall.push_back(took.count());
    }
    out.frames = frames;
    for (const std::string& name : order) {
        out.passes.push_back(statistics(name, by_name[name]));
    }
    out.gpu = statistics("frame (GPU)", gpu);
    out.wall = statistics("frame (wall)", wall);
    return out;
}

std::string to_table(const Timings& timings) {
    std::string text = fmt::format("{:<24} {:>12} {:>12}\n", "pass", "median, ms", "p95, ms");
    const auto line = [&](const PassTiming& timing) {
        text += fmt::format("{:<24} {:>12.4f} {:>12.4f}\n", timing.name, timing.median, timing.p95);
    };
    for (const PassTiming& pass : timings.passes) {
        line(pass);
    }
    line(timings.gpu);
    line(timings.wall);
    return text;
}

std::string to_json(const Timings& timings, const std::string& device, Size size) {
    nlohmann::json passes = nlohmann::json::array();
    for (const PassTiming& pass : timings.passes) {
        passes.push_back(json_of(pass));
    }
    const nlohmann::json all = {{"device", device},
                                {"width", size.width},
                                {"height", size.height},
                                {"frames", timings.frames},
                                {"passes", passes},
                                {"frame_gpu", json_of(timings.gpu)},
                                {"frame_wall", json_of(timings.wall)}};
    return all.dump(2, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string to_text(const Report& report) {
    std::string text = report.explanation;
    if (report.probe) {
        text += probe_table(*report.probe, report.place);
    }
    if (report.figures) {
        text += fmt::format("dE2000  mean {:.3f}  p95 {:.3f}  p99 {:.3f}  max {:.3f}\n",
                            report.figures->mean, report.figures->p95, report.figures->p99,
                            report.figures->max);
    }
    if (report.timings) {
        text += to_table(*report.timings);
    }
    return text;
}

std::string to_json(const Report& report) {
    nlohmann::json all = nlohmann::json::object();
    if (report.timings) {
        all = nlohmann::json::parse(to_json(*report.timings, report.device, report.size));
    }
    if (report.probe) {
        nlohmann::json probe = nlohmann::json::parse(probe_json(*report.probe, report.place));
        if (report.timings || report.figures || !report.explanation.empty()) {
            all["probe"] = std::move(probe);
        } else {
            all = std::move(probe);
        }
    }
    if (report.figures) {
        all["difference"] = {{"mean", report.figures->mean},
                             {"p95", report.figures->p95},
                             {"p99", report.figures->p99},
                             {"max", report.figures->max}};
    }
    std::istringstream lines(report.explanation);
    for (std::string line; std::getline(lines, line);) {
        all["explanation"].push_back(line);
    }
    return all.dump(2, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace preview
