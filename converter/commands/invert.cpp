// lutconv invert: a LUT that undoes a look, and what of the look cannot be undone.
#include "lutlib/resample/invert.h"
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/result.h"
#include "converter/usage.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/metrics/compare.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace converter {
namespace {

struct Options {
    std::string input, output;
    int size = 0;
    std::vector<float> domain;
    bool json = false;
};

// How near inverse and look, one after the other, come to changing nothing: over the look's inputs.
lutlib::Difference round_trip(const lutlib::Lut& look, const lutlib::Lut& inverse) {
    const auto both =
        lutlib::in_sequence({lutlib::Transform::of(look, lutlib::Interpolation::tetrahedral),
                             lutlib::Transform::of(inverse, lutlib::Interpolation::tetrahedral)});
    return compare({}, both, lutlib::samples_over(look.domain(), 33), lutlib::srgb());
}

nlohmann::ordered_json region_json(const lutlib::InverseRegion& region, std::size_t nodes) {
    return {{"nodes", region.count},
            {"share", static_cast<double>(region.count) / static_cast<double>(nodes)},
            {"low", {region.low.r, region.low.g, region.low.b}},
            {"high", {region.high.r, region.high.g, region.high.b}},
            {"worst", {region.worst.r, region.worst.g, region.worst.b}},
            {"extent", region.extent}};
}

std::string region_text(const char* what, const char* extent, const lutlib::InverseRegion& region,
                        std::size_t nodes) {
    if (region.count == 0) {
        return fmt::format("  {}: none\n", what);
    }
    return fmt::format("  {}: {:.3g} % of the nodes ({}), within {} to {}; worst {}, {} {:.4g}\n",
                       what, 100 * static_cast<double>(region.count) / static_cast<double>(nodes),
                       region.count, color_text(to_double(region.low)),
                       color_text(to_double(region.high)), color_text(to_double(region.worst)),
                       extent, region.extent);
}

int run(const Options& o) {
    lutlib::InvertOptions options;
    if (o.size) {
        options.size = o.size;
    }
    if (!o.domain.empty()) {
        options.domain = domain_of(o.domain);
    }
    const auto look = read_table(o.input);
    const lutlib::Inversion inversion = invert(*look, options);
    write_look(inversion.lut, o.output);
    const lutlib::Difference error = round_trip(*look, inversion.lut);
    if (o.json) {
        print(nlohmann::ordered_json{{"input", o.input},
                                     {"output", o.output},
                                     {"size", inversion.lut.cube->size},
                                     {"nodes", inversion.nodes},
                                     {"out_of_gamut",
                                      region_json(inversion.out_of_gamut, inversion.nodes)},
                                     {"folded", region_json(inversion.folded, inversion.nodes)},
                                     {"round_trip", to_json(error)}},
              o.output);
        return ok;
    }
    std::string text =
        fmt::format("{} <- inverse of {}\n  {} nodes a side, input {}\n", output_text(o.output),
                    input_text(o.input), inversion.lut.cube->size,
                    lutlib::io::domain_text(inversion.lut.domain()));
    text += region_text("no input gives these, so they got the nearest that can be given",
                        "distance", inversion.out_of_gamut, inversion.nodes);
    text += region_text("folded: several inputs give these, so they got the nearest of them",
                        "the inputs lie apart by", inversion.folded, inversion.nodes);
    text += fmt::format("  the look, then its inverse, against changing nothing, {} colours\n{}",
                        error.absolute.count, to_text(error, "    "));
    print(text, o.output);
    return ok;
}

} // namespace

Run declare_invert(CLI::App& app) {
    const auto o = std::make_shared<Options>();
    app.add_option("LUT", o->input, "a LUT or recipe file, or - for standard input")->required();
    app.add_option("-o,--output", o->output, "the inverse, or - for standard output")->required();
    app.add_option("--size", o->size, "nodes a side of the inverse (default: the look's)")
        ->check(cube_sizes());
    app.add_option("--domain", o->domain,
                   "colours to invert: minimum and maximum (default: 0..1, widened to the look's)")
        ->expected(2);
    app.add_flag("--json", o->json, "print the figures as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
