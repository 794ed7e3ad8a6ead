// lutconv apply: a picture through a LUT, on the codes or floats as the file stores them.
#include "lutlib/interpolation/apply.h"
#include "converter/command.h"
#include "converter/options.h"
#include "converter/report.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <memory>

namespace converter {
namespace {

namespace io = lutlib::io;

struct Options {
    std::string lut, picture, output, depth;
    InterpolationOption interpolation;
    bool json = false;
};

struct Report {
    int width = 0, height = 0;
    std::size_t outside_domain = 0; ///< pixels whose input was clamped to the LUT's domain
    std::size_t clamped = 0;        ///< pixels whose output an integer file clamps to 0..1
    const io::DepthInfo* depth = nullptr;
};

std::string names_of(std::span<const io::Depth> depths) {
    std::string out;
    for (const io::Depth depth : depths) {
        out += (out.empty() ? "" : ", ") + std::string(io::info_of(depth).name);
    }
    return out;
}

// The depth that was asked for, which the file type must hold, else the nearest to the picture's.
io::Depth choose_depth(const std::string& name, std::span<const io::Depth> held, io::Depth usual) {
    if (name.empty()) {
        return io::nearest_depth(usual, held);
    }
    const auto row = std::find_if(held.begin(), held.end(),
                                  [&](io::Depth depth) { return io::info_of(depth).name == name; });
    if (row == held.end()) {
        throw lutlib::UsageError("--depth '" + name + "' is none that this type of file holds; " +
                                 "it holds " + names_of(held));
    }
    return *row;
}

Report apply(const lutlib::Lut& lut, lutlib::Interpolation how, io::FloatImage& image,
             io::Depth depth) {
    const std::size_t pixels = image.rgba.size() / 4;
    float* const rgba = image.rgba.data();
    Report report{image.width, image.height, 0, 0, &io::info_of(depth)};
    report.outside_domain = lutlib::pixels_outside(lut.domain(), rgba, pixels, 4);
    lutlib::apply(lutlib::StoredLut(lut), lutlib::lookup_of(how), rgba, rgba, pixels, 4);
    report.clamped = report.depth->integer ? lutlib::pixels_outside({}, rgba, pixels, 4) : 0;
    return report;
}

void print_report(const Options& o, const Report& r) {
    const auto pixels = static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height);
    if (o.json) {
        print(nlohmann::ordered_json{{"lut", io::input_name(o.lut)},
                                     {"picture", io::input_name(o.picture)},
                                     {"output", io::output_name(o.output)},
                                     {"width", r.width},
                                     {"height", r.height},
                                     {"depth", r.depth->name},
                                     {"pixels_outside_domain", r.outside_domain},
                                     {"pixels_clamped", r.clamped}},
              o.output);
        return;
    }
    std::string text = fmt::format("{} -> {}\n  {}x{} pixels, {}\n", input_text(o.picture),
                                   output_text(o.output), r.width, r.height, r.depth->name);
    const auto share = [&](std::size_t count, const char* what) {
        return count == 0
                   ? ""
                   : fmt::format("  {} pixels ({:.3g} %) {}\n", count,
                                 100 * static_cast<double>(count) / static_cast<double>(pixels),
                                 what);
    };
    text += share(r.outside_domain, "lay outside the LUT's input and were clamped to it");
    text += share(r.clamped, "came out outside 0..1 and were clamped by the file's integers");
    print(text, o.output);
}

int run(const Options& o) {
    require_one_standard_input(std::array{o.lut, o.picture});
    const std::vector<io::Depth> held = io::depths_of(o.output);
    choose_depth(o.depth, held, held.front());
    const lutlib::Lut lut = read_look(o.lut);
    io::FloatImage image = io::read_image(o.picture);
    const io::Depth depth = choose_depth(o.depth, held, image.depth);
    const Report report = apply(lut, o.interpolation.get(), image, depth);
    io::write_image(o.output, image, {depth, image.alpha, {{"Source", io::input_name(o.picture)}}});
    print_report(o, report);
    return ok;
}

} // namespace

Run declare_apply(CLI::App& app) {
    const auto o = std::make_shared<Options>();
    app.add_option("LUT", o->lut, "a LUT of any format, or - for standard input")->required();
    app.add_option("PICTURE", o->picture, "PNG, EXR or another picture, or - for standard input")
        ->required();
    app.add_option("-o,--output", o->output,
                   "the picture to write, or - for a PNG to standard output")
        ->required();
    app.add_option("--depth", o->depth,
                   "uint8, uint16, half or float, as far as the file type holds it (default: the "
                   "nearest to the picture's own)");
    o->interpolation.declare(app, "of the LUT's cube");
    app.add_flag("--json", o->json, "print the figures as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
