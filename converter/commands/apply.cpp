// lutconv apply: a picture through a LUT, on the codes or floats as the file stores them. What else
// the file holds goes into the new one.
#include "converter/command.h"
#include "converter/grade.h"
#include "converter/grade_text.h"
#include "converter/look_files.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/io/file.h"
#include "lutlib/named.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>
#include <memory>
#include <optional>

namespace converter {
namespace {

namespace io = lutlib::io;

struct Options {
    std::string lut, picture, output, depth, picture_encoding, output_encoding, layer;
    std::string alpha{alpha_rules().front().name};
    InterpolationOption interpolation;
    PlacingOptions placing;
    bool json = false;
};

std::optional<lutlib::Encoding> named_encoding(const std::string& name, const char* option) {
    return name.empty() ? std::nullopt : std::optional(encoding_of(name, option));
}

void print_report(const Options& o, const Grading& grading, const Graded& graded) {
    if (o.json) {
        nlohmann::ordered_json json{{"lut", io::input_name(o.lut)}};
        json.update(to_json(graded, o.picture, o.output));
        print(json, o.output);
        return;
    }
    std::string text = fmt::format("{} -> {}\n  {}\n", input_text(o.picture), output_text(o.output),
                                   size_text(graded));
    std::vector<std::string> lines = lines_of(graded, grading, o.output);
    const std::vector<std::string> counted = lines_of(graded.counts);
    lines.insert(lines.end(), counted.begin(), counted.end());
    for (const std::string& line : lines) {
        text += "  " + line + '\n';
    }
    print(text, o.output);
}

int run(const Options& o, const Verb& verb) {
    require_one_standard_input(std::array{o.lut, o.picture});
    const AlphaRule& alpha = lutlib::require_named(alpha_rules(), "alpha rule", o.alpha);
    const std::vector<io::Depth> held = require_depth(o.depth, o.output);
    const io::Look look =
        open_look(o.lut, {.interpolation = o.interpolation.get(), .encodings = o.placing.look()});
    const Grading grading{look,
                          alpha,
                          named_encoding(o.picture_encoding, "--picture-encoding"),
                          named_encoding(o.output_encoding, "--output-encoding"),
                          o.placing.convert(),
                          o.placing.adaptation(),
                          o.depth,
                          o.layer};
    const Graded graded = grade_file(grading, o.picture, o.output, held);
    tell_unused(verb, {interpolation_part(has_lattice(look)),
                       adaptation_part(graded.place.applied()),
                       {"--alpha", graded.has_alpha, "the picture has no alpha"}});
    print_report(o, grading, graded);
    return ok;
}

} // namespace

Run declare_apply(Verb& verb) {
    const auto o = std::make_shared<Options>();
    verb.add_option("LUT", o->lut, "a LUT of any format or a recipe, or - for standard input")
        .required();
    verb.add_option("PICTURE", o->picture, "PNG, EXR or another picture, or - for standard input")
        .required();
    verb.add_option("-o,--output", o->output,
                    "the picture to write, or - for a PNG to standard output")
        .required();
    verb.add_option("--depth", o->depth,
                    "uint8, uint16, half or float, as far as the file type holds it (default: the "
                    "nearest to the picture's own)");
    o->interpolation.declare(verb, "of the LUT's cube");
    verb.add_option(
        "--layer", o->layer,
        "the picture to grade in a file of several: a layer, or a part's name (default: "
        "R, G, B, else Combined, beauty or rgba, else the first)");
    std::string alpha_help = "how the picture's alpha stands to its colours:";
    for (const AlphaRule& rule : alpha_rules()) {
        alpha_help += fmt::format(" {} ({}){}", rule.name, rule.help,
                                  &rule == &alpha_rules().back() ? "" : ",");
    }
    verb.add_option("--alpha", o->alpha, alpha_help).capture_default_str();
    verb.add_option("--picture-encoding", o->picture_encoding,
                    encoding_help("what the picture's codes are"));
    verb.add_option("--output-encoding", o->output_encoding,
                    "what the written picture's codes are to be (default: the picture's own where "
                    "the look keeps its encoding, else what the look gives)");
    o->placing.declare(verb);
    verb.add_flag("--json", o->json, "print the results as JSON");
    return [o, &verb] { return run(*o, verb); };
}

} // namespace converter
