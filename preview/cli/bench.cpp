// preview_bench: times the passes that every pixel goes through against a plain copy, on whatever
// GPU there is. Needs nothing but a driver; takes no files.
//
// Beside the median time of a pass stand the bytes that it has to move (each image read and written
// once), the ratio of its time to the copy's, and the time that the copy's bandwidth allows for
// those bytes.
#include "lutlib/error.h"
#include "preview/cli/pass_bench.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>

namespace preview {
namespace {

std::string table_of(const Bench& bench, const std::string& device, Size size) {
    std::string text = fmt::format("{}, {}x{}\n\n{:<24} {:<28} {:>10} {:>9} {:>8} {:>11} {:>7}\n",
                                   device, size.width, size.height, "group", "pass", "median ms",
                                   "MB", "x copy", "allowed ms", "GB/s");
    for (const PassRow& row : bench.rows()) {
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
    for (const PassRow& row : bench.rows()) {
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

int run(const BenchOptions& options) {
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
    preview::BenchOptions options;
    app.add_option("--width", options.width)->check(CLI::Range(16U, 16384U));
    app.add_option("--height", options.height)->check(CLI::Range(16U, 16384U));
    app.add_option("--frames", options.frames, "Frames that are measured")
        ->check(CLI::Range(1, 100000));
    app.add_flag("--effects", options.only_effects, "Time the effects alone, beside a copy");
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
