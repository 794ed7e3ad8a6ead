#include "preview/cli/pass_bench.h"

#include "lutlib/error.h"
#include "preview/cli/bench_pictures.h"
#include "preview/effects/effect.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/passes/copy.h"
#include "preview/passes/finish.h"
#include "preview/passes/scope.h"
#include "preview/scene/gpu_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace preview {
namespace {

constexpr int repeats = 8; ///< of a pass within a frame
constexpr int warm_up = 5;
// A GPU lowers its clocks while pipelines are made, and takes its time to raise them again.
constexpr std::chrono::milliseconds settling{400};

double median(std::vector<double> values) {
    if (values.empty()) {
        throw lutlib::Error("this device cannot time passes: it has no timestamps");
    }
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

bool any_pass(const std::string&) {
    return true;
}

/// What those passes of a graph that `counts` accepts must move in a steady frame: every image that
/// they read or write, once each.
std::uint64_t bytes_moved(const Graph& graph,
                          const std::function<bool(const std::string&)>& counts = any_pass) {
    const Plan plan = make_plan(graph, make_plan(graph).held);
    std::uint64_t bytes = 0;
    for (const Step& step : plan.steps) {
        const PassRecord& pass = graph.passes()[step.pass];
        if (!counts(pass.name)) {
            continue;
        }
        for (const Use& use : pass.uses) {
            if (use.version != Version::none && plan.version_lives[use.version] &&
                graph.resource_of(use.version).kind == ResourceKind::image) {
                bytes += graph.resource_of(use.version).image.bytes();
            }
        }
    }
    return bytes;
}

} // namespace

Bench::Bench(const gpu::Device& device, const BenchOptions& options)
    : device_(device), options_(options), executor_(device), size_{options.width, options.height} {
    const auto texels = picture_texels(size_, 1);
    const auto codes = codes_of(texels);
    display_.emplace(gpu::make_image(device, {Format::rgba8, size_.width, size_.height},
                                     std::as_bytes(std::span(codes))));
    hdr_.emplace(half_image(picture_texels(size_, 40)));
    const std::vector<float> depth = picture_depths(size_);
    depth_.emplace(gpu::make_image(device, {Format::r32f, size_.width, size_.height},
                                   std::as_bytes(std::span(depth))));
}

void Bench::run() {
    if (options_.only_effects) {
        copy_ = time_copy("rgba16f to rgba8", *hdr_);
        add(copy_, copy_);
        time_effects();
        return;
    }
    time_lookups("rgba8", *display_);
    time_lookups("rgba16f", *hdr_);
    time_finishing();
    time_scopes();
    time_effects();
    time_sample();
}

gpu::Image Bench::half_image(const std::vector<float>& texels) {
    const gpu::Image light = gpu::make_image(device_, {Format::rgba32f, size_.width, size_.height},
                                             std::as_bytes(std::span(texels)));
    Graph graph;
    const ImageHandle half =
        add_copy(graph, graph.import("light", light, light.desc()), Format::rgba16f);
    graph.present(half);
    executor_.render(graph);
    return gpu::make_image(device_, graph.image_desc(half), executor_.read_image(half));
}

/// The median time of one step among those whose names `counts` accepts, added up by frame and
/// divided by `divisor`.
double Bench::time(const Graph& graph, const std::function<bool(const std::string&)>& counts,
                   int divisor) {
    executor_.render(graph);
    executor_.wait();
    const auto settled = std::chrono::steady_clock::now() + settling;
    for (int frame = 0; frame < warm_up || std::chrono::steady_clock::now() < settled; ++frame) {
        executor_.render(graph);
    }
    std::vector<double> sums;
    for (int frame = 0; frame < options_.frames; ++frame) {
        executor_.render(graph);
        double sum = 0;
        for (const StepTime& step : executor_.timings()) {
            sum += counts(step.name) ? step.milliseconds : 0;
        }
        sums.push_back(sum / divisor);
    }
    return median(sums);
}

/// One pass several times over; declare() adds it and returns what it writes.
PassRow Bench::measure(std::string group, std::string name, const std::string& pass,
                       const std::function<ImageHandle(Graph&)>& declare) {
    Graph once;
    once.present(declare(once));
    Graph graph;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        graph.present(declare(graph));
    }
    PassRow row;
    row.group = std::move(group);
    row.name = std::move(name);
    row.bytes = bytes_moved(once);
    row.milliseconds = time(
        graph, [&](const std::string& step) { return step == pass; }, repeats);
    return row;
}

void Bench::add(PassRow row, const PassRow& copy) {
    row.ratio = row.milliseconds / copy.milliseconds;
    row.allowed =
        copy.milliseconds * static_cast<double>(row.bytes) / static_cast<double>(copy.bytes);
    std::fprintf(stderr, "%s %s: %.4f ms\n", row.group.c_str(), row.name.c_str(), row.milliseconds);
    rows_.push_back(std::move(row));
}

PassRow Bench::time_copy(const std::string& name, const gpu::Image& image) {
    return measure("copy", name, "copy", [&](Graph& graph) {
        return add_copy(graph, graph.import("picture", image, image.desc()), Format::rgba8);
    });
}

/// Every lookup from a picture of one format into 8 bits, beside the copy that does no more.
void Bench::time_lookups(const std::string& format, const gpu::Image& image) {
    const std::string both = format + " to rgba8";
    const auto picture = [&](Graph& graph) { return graph.import("picture", image, image.desc()); };
    copy_ = time_copy(both, image);
    add(copy_, copy_);
    for (const GpuLookup& lookup : gpu_lookups()) {
        if (lookup.source == GpuLookup::Source::none) {
            continue;
        }
        GpuLook look(device_, look_for(sample_look(lookup.shared() ? 16 : 33), lookup).data);
        const auto time_look = [&](const std::string& name) {
            PassRow row = measure("lut, " + both, name, "finish", [&](Graph& graph) {
                return add_finish(graph, {picture(graph), {}, &look, nullptr, {}}).picture;
            });
            row.exact = !lookup.filtered;
            add(std::move(row), copy_);
        };
        time_look(std::string(lookup.name));
        if (lookup.shared() && look.half_arithmetic) {
            look.half_arithmetic = false;
            time_look(std::string(lookup.name) + ", float");
        }
    }
    // Again after all the others: the clocks may have moved.
    add(time_copy(both + ", again", image), copy_);
}

void Bench::time_finishing() {
    const GpuLook look(device_,
                       look_for(sample_look(16), *gpu_lookup_named("shared-tetrahedral")).data);
    for (const Bloom& bloom : blooms()) {
        for (const float threshold : {0.0F, 1.0F}) {
            Graph graph;
            // Written just before, as it is in a frame.
            const ImageHandle hdr =
                add_copy(graph, graph.import("hdr", *hdr_, hdr_->desc()), Format::rgba16f);
            BloomSettings bloom_settings;
            bloom_settings.threshold = threshold;
            const BloomPlan plan =
                bloom_plan(bloom, {static_cast<int>(size_.width), static_cast<int>(size_.height)},
                           bloom_settings);
            FinishSettings settings;
            settings.tonemap = tonemap_named("agx");
            const ImageHandle done =
                add_finish(graph, {hdr, add_bloom(graph, hdr, plan), &look, nullptr, settings})
                    .picture;
            graph.present(done);
            PassRow row;
            row.group = "bloom + tone map + lut";
            row.name = fmt::format("{}, threshold {}", bloom.name, threshold);
            row.bytes = bytes_moved(graph) - 2 * hdr_->desc().bytes();
            row.milliseconds = time(
                graph, [](const std::string& step) { return step != "copy"; }, 1);
            add(std::move(row), copy_);
        }
    }
}

/// Counting reads the picture once; drawing costs the same for every picture.
void Bench::time_scopes() {
    const ScopeArea all{.width = size_.width, .height = size_.height};
    for (const Scope& scope : scopes) {
        const std::string name(scope.name);
        const auto declare = [&](Graph& graph) {
            return add_scope(graph, graph.import("display", *display_, display_->desc()), scope,
                             all, {{scope.width, scope.height}, scope.logarithmic})
                .picture;
        };
        PassRow counted = measure("scope", name + ", counted", "count " + name, declare);
        counted.bytes = std::uint64_t{4} * size_.width * size_.height;
        add(std::move(counted), copy_);
        PassRow drawn = measure("scope", name + ", drawn", "draw " + name, declare);
        drawn.bytes = std::uint64_t{4} * scope.width * scope.height;
        add(std::move(drawn), copy_);
    }
}

/// Each as it is usually used, all its passes, over the picture that its stage has.
void Bench::time_effects() {
    for (const PostEffect* effect : post_effects()) {
        EffectUse use = usual_use(*effect);
        if (effect->idle_because != nullptr) {
            set_number(use, "focus", 2); // metres: with much before it and much behind
        }
        const gpu::Image& picture = is_on_codes(effect->stage) ? *display_ : *hdr_;
        const auto declare = [&](Graph& graph) {
            EffectInput in{graph.import("picture", picture, picture.desc()), size_.width, 0.5};
            if (effect->needs_depth) {
                in.depth = {graph.import("depth", *depth_, depth_->desc()), depths_near_plane, 0.5F,
                            2.75F};
            }
            return effect->add(graph, in, use.values);
        };
        Graph once, graph;
        once.present(declare(once));
        for (int repeat = 0; repeat < repeats; ++repeat) {
            graph.present(declare(graph));
        }
        PassRow row;
        row.group = "effect";
        row.name = std::string(effect->name);
        row.bytes = bytes_moved(once);
        row.milliseconds = time(
            graph, [](const std::string&) { return true; }, repeats);
        add(std::move(row), copy_);
    }
}

void Bench::time_sample() {
    const Scene scene = scene_at(*scene_named("sample"), 0);
    const GpuScene gpu_scene(device_, scene);
    const GpuLook look(device_,
                       look_for(sample_look(16), *gpu_lookup_named("shared-tetrahedral")).data);
    FrameInputs inputs;
    inputs.scene = &scene;
    inputs.gpu_scene = &gpu_scene;
    inputs.look_a = &look;
    FrameSettings settings;
    settings.output = size_;
    settings.orbit = scene.orbit;
    settings.tonemap = tonemap_named("agx");
    settings.bloom = bloom_named("glare");
    bool has_compute = false;
    for (const RasterChoice& choice : rasters().subspan(1)) {
        try {
            settings.raster = choice.on(device_, size_);
        } catch (const lutlib::UsageError&) {
            continue; // not on this device
        }
        has_compute = has_compute || settings.raster == Raster::compute;
        time_frame(std::string(choice.name), inputs, settings);
        frames_.push_back({std::string(choice.name), frame_});
    }
    settings.raster = has_compute ? Raster::compute : Raster::hardware;
    time_parts(inputs, settings);
    time_slider(inputs, settings);
    if (!has_compute) {
        return;
    }
    for (const std::uint32_t side : {8U, 16U, 24U}) {
        settings.visibility.small_side = side;
        time_frame(fmt::format("compute, small up to {}", side), inputs, settings);
    }
}

/// What the light of the surroundings takes: ambient occlusion, and a sky whose sun moves.
void Bench::time_parts(FrameInputs inputs, FrameSettings settings) {
    Surroundings sky;
    sky.kind = SurroundingsKind::sky;
    inputs.surroundings = &sky;
    settings.force_all = true; // else the sky rests
    Graph graph;
    build_frame(graph, inputs, settings);
    for (const std::string part : {"ambient occlusion", "surroundings"}) {
        const auto is_of_part = [&](const std::string& pass) { return pass.starts_with(part); };
        PassRow row;
        row.group = "of the frame";
        row.name = part;
        row.bytes = bytes_moved(graph, is_of_part);
        row.milliseconds = time(graph, is_of_part, 1);
        add(std::move(row), copy_);
    }
}

/// While a slider of the look moves, the light that the look gets rests.
void Bench::time_slider(const FrameInputs& inputs, FrameSettings settings) {
    settings.keeps_light = true;
    Graph graph;
    build_frame(graph, inputs, settings);
    PassRow row;
    row.group = "of the frame";
    row.name = "all that a slider of the look draws";
    row.bytes = bytes_moved(graph, [](const std::string& pass) { return pass == "finish"; });
    row.milliseconds = time(
        graph, [](const std::string&) { return true; }, 1);
    add(std::move(row), copy_);
}

void Bench::time_frame(std::string name, const FrameInputs& inputs, const FrameSettings& settings) {
    Graph graph;
    build_frame(graph, inputs, settings);
    time_frames(executor_, inputs, settings, options_.frames); // until the clocks have settled
    frame_ = time_frames(executor_, inputs, settings, options_.frames);
    PassRow row;
    row.group = "frame, by rasteriser";
    row.name = std::move(name);
    row.bytes = bytes_moved(graph);
    row.milliseconds = frame_.gpu.median;
    add(std::move(row), copy_);
}

} // namespace preview
