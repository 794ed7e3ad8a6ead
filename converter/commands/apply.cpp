// lutconv apply: pictures through a LUT, on the codes or floats as the file stores them. What else
// a file holds goes into the new one.
#include "converter/command.h"
#include "converter/grade.h"
#include "converter/grade_many.h"
#include "converter/grade_stream.h"
#include "converter/grade_text.h"
#include "converter/look_files.h"
#include "converter/many.h"
#include "converter/options.h"
#include "converter/placing.h"
#include "converter/recipe_options.h"
#include "converter/replaceable.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/named.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace converter {
namespace {

namespace io = lutlib::io;

struct ApplyOptions {
    std::vector<std::string> pictures;
    std::string lut, output, depth, picture_encoding, output_encoding, layer;
    std::string alpha{alpha_rules().front().name};
    InterpolationOption interpolation;
    PlacingOptions placing;
    ManyOptions many;
    double strength = 1;
    bool partial = false, explain = false, json = false;
};

std::optional<lutlib::Encoding> named_encoding(const std::string& name, const char* option) {
    return name.empty() ? std::nullopt : std::optional(encoding_of(name, option));
}

// Of one picture that was named by itself.
void print_report(const ApplyOptions& o, const io::Route& route, const Grading& grading,
                  const Graded& graded) {
    if (o.json) {
        nlohmann::ordered_json json{{"lut", io::input_name(o.lut)}};
        json.update(to_json(graded, route.from.path, route.to));
        print(json, route.to);
        return;
    }
    std::string text = fmt::format("{} -> {}\n  {}\n", input_text(route.from.path),
                                   output_text(route.to), size_text(graded));
    std::vector<std::string> lines = lines_of(graded, grading, route.to);
    const std::vector<std::string> counted = lines_of(graded.counts);
    lines.insert(lines.end(), counted.begin(), counted.end());
    for (const std::string& line : lines) {
        text += "  " + line + '\n';
    }
    print(text, route.to);
}

// From which pictures to which, whether this run makes them or not.
std::vector<io::Route> routes_of(const io::Inputs& inputs, const io::OutputTemplate& output) {
    std::vector<io::Route> out;
    for (io::InputFile file : inputs.files) {
        if (file.path == io::standard_stream) {
            file.frame = "1"; // of those that come
        }
        out.push_back({file, output.path_for(file)});
    }
    require_distinct(out);
    return out;
}

std::vector<std::string> files_of(const io::Look& look) {
    std::vector<std::string> out;
    for (const io::LookFile& file : look.files()) {
        out.push_back(file.name);
    }
    return out;
}

void tell_unused(const Verb& verb, const io::Look& look,
                 const std::vector<std::optional<Graded>>& pictures) {
    bool has_alpha = pictures.empty();
    const lutlib::LookEncodings encodings = look.encodings();
    const std::string unknown = "what the look takes and gives is not known: say it with "
                                "--look-input and --look-output";
    Part adaptation{"--adaptation", pictures.empty(), ""};
    bool would_convert = pictures.empty();
    for (const auto& graded : pictures) {
        has_alpha = has_alpha || !graded || graded->has_alpha;
        would_convert = would_convert || !graded || graded->place.needed().converts();
        if (graded && !adaptation.has_part) {
            adaptation = adaptation_part(graded->place.applied());
        }
    }
    tell_unused(verb, {interpolation_part(has_lattice(look)),
                       adaptation,
                       no_convert_part(would_convert),
                       {"--alpha", has_alpha, "no picture has alpha"},
                       {"--picture-encoding", encodings.input.has_value(), unknown},
                       {"--output-encoding", encodings.output.has_value(), unknown}});
}

int run_apply(const ApplyOptions& o, const Verb& verb) {
    std::vector<std::string> inputs_named = o.pictures;
    inputs_named.push_back(o.lut);
    require_one_standard_input(inputs_named);
    const AlphaRule& alpha = lutlib::require_named(alpha_rules(), "alpha rule", o.alpha);
    const io::Inputs inputs =
        io::find_inputs(o.pictures, o.many.frames(), io::is_picture_extension);
    const io::OutputTemplate output(o.output);
    std::vector<io::Route> routes = o.many.of_shard(routes_of(inputs, output));
    for (const io::Route& route : routes) {
        io::require_another_than(o.lut, "the look", route.to);
    }
    tell_remarks(inputs.remarks);
    if (o.many.only_says_missing()) {
        const std::size_t there = take_out_done(routes, files_of(open_look(o.lut)));
        return tell_missing(routes, there, "pictures", o.json);
    }
    if (output.varies()) {
        make_folders(routes);
    }
    const bool is_one = inputs.files.size() == 1 && !inputs.are_listed && !o.many.resumes();
    const std::vector<io::Depth> held =
        is_one && !routes.empty() ? require_depth(o.depth, routes[0].to) : std::vector<io::Depth>{};
    const io::Look look =
        open_look(o.lut, {.interpolation = o.interpolation.get(), .encodings = o.placing.look()});
    const Grading grading{look,
                          alpha,
                          named_encoding(o.picture_encoding, "--picture-encoding"),
                          named_encoding(o.output_encoding, "--output-encoding"),
                          o.placing.convert(),
                          o.placing.adaptation(),
                          o.depth,
                          {o.layer, o.partial},
                          o.strength,
                          o.explain};
    const std::size_t there = o.many.resumes() ? take_out_done(routes, files_of(look)) : 0;
    require_replaceable(routes);
    if (is_one && !routes.empty() && routes[0].from.path == io::standard_stream) {
        const GradedStream stream = grade_stream(grading, output, o.many);
        tell_unused(verb, look, stream.graded.pictures);
        if (stream.is_one) {
            print_report(o, stream.routes[0], grading, *stream.graded.pictures[0]);
        } else {
            print_report(stream.graded, grading, stream.routes, o.lut, output.text(), o.json);
        }
        return stream.graded.failures.empty() ? ok : bad_input;
    }
    if (is_one && !routes.empty()) {
        const Graded graded = grade_file(grading, routes[0].from.path, routes[0].to, held);
        tell_unused(verb, look, {graded});
        print_report(o, routes[0], grading, graded);
        return ok;
    }
    GradedMany graded = grade_many(grading, routes, o.many, output.text());
    graded.there = there;
    tell_unused(verb, look, graded.pictures);
    print_report(graded, grading, routes, o.lut, output.text(), o.json);
    return graded.failures.empty() ? ok : bad_input;
}

} // namespace

Run declare_apply(Verb& verb) {
    const auto o = std::make_shared<ApplyOptions>();
    verb.add_option("LUT", o->lut, "a LUT of any format or a recipe, or - for standard input")
        .required();
    verb.add_option("PICTURES", o->pictures,
                    "PNG, EXR or other pictures, or - for standard input; folders of them; frames, "
                    "as shot.####.exr or shot.%04d.exr")
        .required();
    verb.add_output(
            "-o,--output", o->output,
            "the picture to write, or - for a PNG to standard output; of several pictures a "
            "folder, or names with {name}, {ext}, {frame} or #### in them",
            OutputName::is_template)
        .required();
    verb.add_option("--depth", o->depth,
                    lutlib::names_of(io::depths()) +
                        ", as far as the file type holds it (default: the nearest to the "
                        "picture's own)");
    o->interpolation.declare(verb, "of the LUT's cube");
    verb.add_option("--strength", o->strength,
                    "how much of the look: 0 leaves the picture as it is, 1 grades it in full; "
                    "between them the picture's own codes and the graded ones are mixed")
        .takes(Takes::share)
        .capture_default_str();
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
    o->many.declare(verb);
    verb.add_flag("--partial", o->partial,
                  "grade what is there of a picture that is cut short or damaged; else that is an "
                  "error");
    verb.add_flag("--explain", o->explain,
                  "say what a picture did not need of the look, and was left out");
    verb.add_flag("--json", o->json, "print the results as JSON");
    return [o, &verb] { return run_apply(*o, verb); };
}

} // namespace converter
