// lutconv apply: a picture through a LUT, on the codes or floats as the file stores them.
#include "lutlib/interpolation/apply.h"
#include "converter/command.h"
#include "converter/options.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/image.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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

// The picture's own depth, as far as the file type has it: PNG stores integers, EXR floats.
io::Depth usual_depth(const io::FloatImage& image, const std::string& output) {
    const std::string extension = io::extension_of(output);
    const bool integer = io::info_of(image.depth).integer;
    if ((extension == "png" || output == io::standard_stream) && !integer) {
        return io::Depth::uint16;
    }
    if (extension == "exr" && integer) {
        // Half holds every 8-bit code apart, 16-bit codes need float.
        return image.depth == io::Depth::uint8 ? io::Depth::half : io::Depth::float32;
    }
    return image.depth;
}

io::Depth depth_named(const std::string& name) {
    std::string names;
    for (const io::DepthInfo& row : io::depths()) {
        if (row.name == name) {
            return row.depth;
        }
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    }
    throw lutlib::UsageError("there is no depth '" + name + "'; there are " + names);
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
    if (o.lut == io::standard_stream && o.picture == io::standard_stream) {
        throw lutlib::UsageError("the LUT and the picture cannot both be standard input");
    }
    const lutlib::Lut lut = read_look(o.lut);
    io::FloatImage image = io::read_image(o.picture);
    const io::Depth depth = o.depth.empty() ? usual_depth(image, o.output) : depth_named(o.depth);
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
                   "uint8, uint16, half or float (default: the picture's own)");
    o->interpolation.declare(app, "of the LUT's cube");
    app.add_flag("--json", o->json, "print the figures as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
