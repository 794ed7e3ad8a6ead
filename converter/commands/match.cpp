// lutconv match: the look that made one picture of another.
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/match_pairs.h"
#include "converter/match_run.h"
#include "converter/match_text.h"
#include "converter/paint_picture.h"
#include "converter/recipe_options.h"
#include "converter/report.h"
#include "converter/usage.h"

#include <nlohmann/json.hpp>

#include <array>
#include <memory>

namespace converter {
namespace {

struct Options {
    std::vector<std::string> pictures;
    std::string output, frames, before_encoding, after_encoding, look_input, look_output;
    int size = lutlib::MatchSettings{}.size;
    bool force = false, json = false;
};

std::optional<lutlib::Encoding> named(const std::string& name, const std::string& option) {
    return name.empty() ? std::nullopt : std::optional(encoding_of(name, option));
}

PairEncodings encodings_of(const Options& o) {
    return {{named(o.before_encoding, "--before-encoding"),
             named(o.after_encoding, "--after-encoding")},
            {named(o.look_input, "--look-input"), named(o.look_output, "--look-output")}};
}

lutlib::Lut look_of(const Matched& matched) {
    lutlib::Lut out;
    out.cube = matched.match.cube;
    out.encodings = names_of(matched.look);
    return out;
}

int run(const Options& o) {
    require_one_standard_input(o.pictures);
    const std::string shown = standard_output_of(std::array{o.output});
    const PairEncodings encodings = encodings_of(o);
    const std::vector<PairPaths> pairs = pairs_of(o.pictures, o.frames);
    std::vector<std::string> inputs;
    for (const PairPaths& pair : pairs) {
        inputs.insert(inputs.end(), {pair.before, pair.after});
    }
    require_replaceable(o.output, inputs, o.force);
    const Matched matched = match_pairs(pairs, encodings, o.size);
    tell_losses(write_look(look_of(matched), o.output), o.output);
    o.json ? print(match_json(matched, o.output), shown)
           : print(match_text(matched, o.output), shown);
    return ok;
}

} // namespace

Run declare_match(Verb& verb) {
    const auto o = std::make_shared<Options>();
    verb.add_option("PICTURES", o->pictures,
                    "BEFORE AFTER: a picture and the same once it was graded, and more such pairs; "
                    "folders and patterns of frames (shot.####.png) are paired by name and number")
        .required();
    verb.add_option("-o,--output", o->output,
                    "a LUT file of any extension, or - for standard output")
        .required();
    verb.add_option("--size", o->size, "nodes per axis")
        .takes(Takes::cube_size)
        .capture_default_str();
    verb.add_option("--frames", o->frames, "of a pattern: 1001-1100 or 1001-1100x2 (default: all)");
    verb.add_option("--before-encoding", o->before_encoding,
                    encoding_help("what the codes of BEFORE are") +
                        " (default: what its file says, else srgb)");
    verb.add_option("--after-encoding", o->after_encoding, "the same of AFTER");
    verb.add_option("--look-input", o->look_input,
                    "what the look shall take (default: BEFORE's codes; srgb where that holds "
                    "light)");
    verb.add_option("--look-output", o->look_output, "what it shall give, in the same way");
    verb.add_flag("--force", o->force,
                  "overwrite a picture that lutconv did not make, or one that this run reads");
    verb.add_flag("--json", o->json, "print the results as JSON");
    return [o] { return run(*o); };
}

} // namespace converter
