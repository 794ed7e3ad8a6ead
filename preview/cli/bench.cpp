// preview_bench: times the passes that every pixel goes through against a plain copy, on whatever
// GPU there is. Needs nothing but a driver; takes no files.
//
// Every pass is timed by GPU timestamps, several times a frame over many frames; the median counts.
// Beside it stand the bytes that it has to move (each image read and written once), the ratio of
// its time to the copy's, and the time that the copy's bandwidth allows for those bytes.
#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "preview/cli/headless.h"
#include "preview/frame/frame.h"
#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/passes/copy.h"
#include "preview/passes/finish.h"
#include "preview/passes/scope.h"
#include "preview/scene/gpu_scene.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>

namespace preview {
namespace {

struct Options {
    std::uint32_t width = 3840, height = 2160;
    int frames = 60;
    bool json = false;
    std::string device, output;
};

struct Row {
    std::string group, name;
    double milliseconds = 0;
    std::uint64_t bytes = 0;
    double ratio = 0;   ///< to the copy of the same formats
    double allowed = 0; ///< milliseconds for those bytes at the copy's bandwidth
    bool exact = true;  ///< not left to the texture unit's filter
};

/// The sample scene with everything on, by one rasteriser.
struct FrameTimings {
    std::string raster;
    Timings timings;
};

constexpr int repeats = 8; ///< of a pass within a frame
constexpr int warm_up = 5;
// A GPU lowers its clocks while pipelines are made, and takes its time to raise them again.
constexpr std::chrono::milliseconds settling{400};

/// A look that mixes channels and bends tones: saturation and an S-curve.
lutlib::Lut sample_look(int size) {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(size);
    for (lutlib::Rgb& node : look.cube->nodes) {
        const float luma = 0.2126F * node.r + 0.7152F * node.g + 0.0722F * node.b;
        for (std::size_t c = 0; c < 3; ++c) {
            const float v = std::clamp(luma + 1.3F * (node[c] - luma), 0.0F, 1.0F);
            node[c] = v * v * (3 - 2 * v);
        }
    }
    return look;
}

/// A picture with the statistics of a photograph: smooth, with edges, fine noise and a few lights.
std::vector<float> picture_texels(Size size, float brightest) {
    std::vector<float> texels;
    texels.reserve(std::size_t{4} * size.width * size.height);
    std::uint32_t state = 1;
    for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(size.width);
            const float v = static_cast<float>(y) / static_cast<float>(size.height);
            state = state * 1664525U + 1013904223U;
            const float noise = static_cast<float>(state >> 8) / 16777216.0F * 0.02F;
            const bool block = (x / 160 + y / 120) % 3 == 0;
            const bool lamp = x % 640 < 12 && y % 540 < 12;
            const float base = lamp ? brightest : 1.0F;
            texels.insert(texels.end(),
                          {base * (block ? 0.9F - u * 0.6F : u) + noise,
                           base * (block ? v : 0.2F + 0.6F * v) + noise,
                           base * (0.5F + 0.4F * std::sin(7 * u + 3 * v)) + noise, 1.0F});
        }
    }
    return texels;
}

std::vector<std::uint8_t> codes_of(const std::vector<float>& texels) {
    std::vector<std::uint8_t> codes;
    codes.reserve(texels.size());
    for (const float v : texels) {
        codes.push_back(static_cast<std::uint8_t>(lutlib::CodeDepth{8}.code(v)));
    }
    return codes;
}

double median(std::vector<double> values) {
    if (values.empty()) {
        throw lutlib::Error("this device cannot time passes: it has no timestamps");
    }
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

/// What the passes of a graph must move in a steady frame: every image that they read or write,
/// once each.
std::uint64_t bytes_moved(const Graph& graph) {
    const Plan plan = make_plan(graph, make_plan(graph).held);
    std::uint64_t bytes = 0;
    for (const Step& step : plan.steps) {
        for (const Use& use : graph.passes()[step.pass].uses) {
            if (use.version != Version::none && plan.version_lives[use.version] &&
                graph.resource_of(use.version).kind == ResourceKind::image) {
                bytes += graph.resource_of(use.version).image.bytes();
            }
        }
    }
    return bytes;
}

class Bench {
  public:
    Bench(const gpu::Device& device, const Options& options)
        : device_(device), options_(options),
          executor_(device), size_{options.width, options.height} {
        const auto texels = picture_texels(size_, 1);
        const auto codes = codes_of(texels);
        display_.emplace(gpu::make_image(device, {Format::rgba8, size_.width, size_.height},
                                         std::as_bytes(std::span(codes))));
        hdr_.emplace(half_image(picture_texels(size_, 40)));
    }

    void run() {
        time_lookups("rgba8", *display_);
        time_lookups("rgba16f", *hdr_);
        time_finishing();
        time_scopes();
        time_sample();
    }

    const std::vector<Row>& rows() const { return rows_; }
    const std::vector<FrameTimings>& frames() const { return frames_; }

  private:
    gpu::Image half_image(const std::vector<float>& texels) {
        const gpu::Image light =
            gpu::make_image(device_, {Format::rgba32f, size_.width, size_.height},
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
    double time(const Graph& graph, const std::function<bool(const std::string&)>& counts,
                int divisor) {
        executor_.render(graph);
        executor_.wait();
        const auto settled = std::chrono::steady_clock::now() + settling;
        for (int frame = 0; frame < warm_up || std::chrono::steady_clock::now() < settled;
             ++frame) {
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
    Row measure(std::string group, std::string name, const std::string& pass,
                const std::function<ImageHandle(Graph&)>& declare) {
        Graph once;
        once.present(declare(once));
        Graph graph;
        for (int repeat = 0; repeat < repeats; ++repeat) {
            graph.present(declare(graph));
        }
        Row row;
        row.group = std::move(group);
        row.name = std::move(name);
        row.bytes = bytes_moved(once);
        row.milliseconds = time(
            graph, [&](const std::string& step) { return step == pass; }, repeats);
        return row;
    }

    void add(Row row, const Row& copy) {
        row.ratio = row.milliseconds / copy.milliseconds;
        row.allowed =
            copy.milliseconds * static_cast<double>(row.bytes) / static_cast<double>(copy.bytes);
        std::fprintf(stderr, "%s %s: %.4f ms\n", row.group.c_str(), row.name.c_str(),
                     row.milliseconds);
        rows_.push_back(std::move(row));
    }

    /// Every lookup from a picture of one format into 8 bits, beside the copy that does no more.
    void time_lookups(const std::string& format, const gpu::Image& image) {
        const std::string formats = format + " to rgba8";
        const auto picture = [&](Graph& graph) {
            return graph.import("picture", image, image.desc());
        };
        const auto time_copy = [&](const std::string& name) {
            return measure("copy", name, "copy", [&](Graph& graph) {
                return add_copy(graph, picture(graph), Format::rgba8);
            });
        };
        copy_ = time_copy(formats);
        add(copy_, copy_);
        for (const GpuLookup& lookup : gpu_lookups()) {
            if (lookup.source == GpuLookup::Source::none) {
                continue;
            }
            GpuLook look(device_, look_for(sample_look(lookup.shared() ? 16 : 33), lookup).data);
            const auto time_look = [&](const std::string& name) {
                Row row = measure("lut, " + formats, name, "finish", [&](Graph& graph) {
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
        add(time_copy(formats + ", again"), copy_);
    }

    void time_finishing() {
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
                const BloomPlan plan = bloom_plan(
                    bloom, {static_cast<int>(size_.width), static_cast<int>(size_.height)},
                    bloom_settings);
                FinishSettings settings;
                settings.tonemap = tonemap_named("agx");
                const ImageHandle done =
                    add_finish(graph, {hdr, add_bloom(graph, hdr, plan), &look, nullptr, settings})
                        .picture;
                graph.present(done);
                Row row;
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
    void time_scopes() {
        const ColumnRange all{0, size_.width};
        for (const Scope& scope : scopes) {
            const std::string name(scope.name);
            const auto declare = [&](Graph& graph) {
                return add_scope(graph, graph.import("display", *display_, display_->desc()), scope,
                                 all, {scope.width, scope.height}, scope.logarithmic)
                    .picture;
            };
            Row counted = measure("scope", name + ", counted", "count " + name, declare);
            counted.bytes = std::uint64_t{4} * size_.width * size_.height;
            add(std::move(counted), copy_);
            Row drawn = measure("scope", name + ", drawn", "draw " + name, declare);
            drawn.bytes = std::uint64_t{4} * scope.width * scope.height;
            add(std::move(drawn), copy_);
        }
    }

    void time_sample() {
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
        for (const RasterChoice& choice : rasters().subspan(1)) {
            try {
                settings.raster = choice.on(device_, size_);
            } catch (const lutlib::UsageError&) {
                continue; // not on this device
            }
            time_frame(std::string(choice.name), inputs, settings);
            frames_.push_back({std::string(choice.name), frame_});
        }
        if (settings.raster != Raster::compute) {
            return;
        }
        for (const std::uint32_t side : {8U, 24U, 32U}) {
            settings.visibility.small_side = side;
            time_frame(fmt::format("compute, small up to {}", side), inputs, settings);
        }
    }

    void time_frame(std::string name, const FrameInputs& inputs, const FrameSettings& settings) {
        Graph graph;
        build_frame(graph, inputs, settings);
        time_frames(executor_, inputs, settings, options_.frames); // until the clocks have settled
        frame_ = time_frames(executor_, inputs, settings, options_.frames);
        Row row;
        row.group = "frame, by rasteriser";
        row.name = std::move(name);
        row.bytes = bytes_moved(graph);
        row.milliseconds = frame_.gpu.median;
        add(std::move(row), copy_);
    }

    const gpu::Device& device_;
    const Options& options_;
    Executor executor_;
    Size size_;
    std::optional<gpu::Image> display_, hdr_;
    Row copy_;
    std::vector<Row> rows_;
    Timings frame_; ///< of the last row of a frame
    std::vector<FrameTimings> frames_;
};

std::string table_of(const Bench& bench, const std::string& device, Size size) {
    std::string text = fmt::format("{}, {}x{}\n\n{:<24} {:<28} {:>10} {:>9} {:>8} {:>11} {:>7}\n",
                                   device, size.width, size.height, "group", "pass", "median ms",
                                   "MB", "x copy", "allowed ms", "GB/s");
    for (const Row& row : bench.rows()) {
        text += fmt::format("{:<24} {:<28} {:>10.4f} {:>9.1f} {:>8.2f} {:>11.4f} {:>7.0f}{}\n",
                            row.group, row.name, row.milliseconds,
                            static_cast<double>(row.bytes) * 1e-6, row.ratio, row.allowed,
                            static_cast<double>(row.bytes) * 1e-6 / row.milliseconds,
                            row.exact ? "" : "  filtered by the texture unit");
    }
    for (const FrameTimings& frame : bench.frames()) {
        text += fmt::format("\nThe frame, pass by pass, {} raster\n{}", frame.raster,
                            to_table(frame.timings));
    }
    return text;
}

std::string json_of(const Bench& bench, const std::string& device, Size size) {
    nlohmann::json rows = nlohmann::json::array();
    for (const Row& row : bench.rows()) {
        rows.push_back({{"group", row.group},
                        {"name", row.name},
                        {"median_ms", row.milliseconds},
                        {"bytes", row.bytes},
                        {"ratio_to_copy", row.ratio},
                        {"allowed_ms", row.allowed},
                        {"exact", row.exact}});
    }
    nlohmann::json frames = nlohmann::json::object();
    for (const FrameTimings& frame : bench.frames()) {
        frames[frame.raster] = nlohmann::json::parse(to_json(frame.timings, device, size));
    }
    nlohmann::json all = {{"device", device},
                          {"width", size.width},
                          {"height", size.height},
                          {"rows", rows},
                          {"frames", frames}};
    return all.dump(2) + "\n";
}

int run(const Options& options) {
    gpu::DeviceOptions wanted;
    wanted.wanted = options.device;
    const gpu::Device device(wanted);
    Bench bench(device, options);
    bench.run();
    const Size size{options.width, options.height};
    const std::string json = json_of(bench, device.name(), size);
    std::fputs(options.json ? json.c_str() : table_of(bench, device.name(), size).c_str(), stdout);
    if (!options.output.empty()) {
        std::ofstream file(options.output, std::ios::binary);
        if (!(file << json)) {
            throw lutlib::Error("cannot be written", {options.output, 0, {}});
        }
    }
    return 0;
}

} // namespace
} // namespace preview

int main(int argc, char** argv) {
    CLI::App app("Times the preview's passes against a plain copy on this machine's GPU.",
                 "preview_bench");
    preview::Options options;
    app.add_option("--width", options.width)->check(CLI::Range(16U, 16384U));
    app.add_option("--height", options.height)->check(CLI::Range(16U, 16384U));
    app.add_option("--frames", options.frames, "Frames that are measured")
        ->check(CLI::Range(1, 100000));
    app.add_option("--device", options.device, "Part of a GPU's name");
    app.add_flag("--json", options.json, "Print JSON instead of the table");
    app.add_option("-o,--output", options.output, "Also write the JSON to this file");
    try {
        app.parse(argc, argv);
        return preview::run(options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "preview_bench: %s\n", error.what());
        return 2;
    }
}
