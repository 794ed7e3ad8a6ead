// lutconv match: the look that made one picture of another.
#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/match_chart.h"
#include "converter/match_page.h"
#include "converter/match_pairs.h"
#include "converter/match_run.h"
#include "converter/match_text.h"
#include "converter/recipe_options.h"
#include "converter/replaceable.h"
#include "converter/report.h"
#include "converter/usage.h"
#include "lutlib/error.h"

#include <nlohmann/json.hpp>

#include <array>
#include <memory>

namespace converter {
namespace {

struct MatchOptions {
    std::vector<std::string> pictures;
    std::string output, html, chart_before, chart_after, frames, before_encoding, after_encoding,
        look_input, look_output;
    int size = 0; ///< 0: the best of the usual ones
    bool json = false;
};

std::optional<lutlib::Encoding> named_encoding(const std::string& name, const std::string& option) {
    return name.empty() ? std::nullopt : std::optional(encoding_of(name, option));
}

PairEncodings pair_encodings(const MatchOptions& o) {
    return {{named_encoding(o.before_encoding, "--before-encoding"),
             named_encoding(o.after_encoding, "--after-encoding")},
            {named_encoding(o.look_input, "--look-input"),
             named_encoding(o.look_output, "--look-output")}};
}

lutlib::Lut matched_look(const Matched& matched) {
    lutlib::Lut out;
    out.cube = matched.match.cube;
    out.encodings = names_of(matched.look);
    return out;
}

bool has_chart(const MatchOptions& o) {
    return !o.chart_before.empty() || !o.chart_after.empty();
}

// A picture for each chart that was named, the one before the grade first.
Matched from_charts(const MatchOptions& o, const PairEncodings& encodings) {
    const std::size_t wanted = (o.chart_before.empty() ? 0 : 1) + (o.chart_after.empty() ? 0 : 1);
    if (o.pictures.size() != wanted) {
        throw lutlib::UsageError("--chart-before and --chart-after take a picture each, and no "
                                 "picture stands for the published chart");
    }
    if (!o.frames.empty()) {
        throw lutlib::UsageError("--frames is for pairs of pictures, not for charts");
    }
    std::optional<ChartPicture> before, after;
    if (!o.chart_before.empty()) {
        before = {o.pictures.front(), chart_area_of(o.chart_before, "--chart-before")};
    }
    if (!o.chart_after.empty()) {
        after = {o.pictures.back(), chart_area_of(o.chart_after, "--chart-after")};
    }
    return match_charts(before, after, encodings,
                        o.size > 0 ? o.size : lutlib::MatchSettings{}.size);
}

Matched from_pairs(const MatchOptions& o, const PairEncodings& encodings) {
    const std::vector<PairPaths> pairs = pairs_of(o.pictures, o.frames);
    std::vector<std::string> inputs;
    for (const PairPaths& pair : pairs) {
        inputs.insert(inputs.end(), {pair.before, pair.after});
    }
    require_replaceable(o.output, inputs);
    require_replaceable(o.html, inputs);
    return match_pairs(pairs, encodings, o.size > 0 ? std::optional(o.size) : std::nullopt);
}

int run_match(const MatchOptions& o) {
    require_one_standard_input(o.pictures);
    const std::string shown = standard_output_of(std::array{o.output, o.html});
    const PairEncodings encodings = pair_encodings(o);
    const Matched matched = has_chart(o) ? from_charts(o, encodings) : from_pairs(o, encodings);
    const std::string page = o.html.empty() ? "" : match_html(matched, o.output);
    std::vector<lutlib::io::FileToWrite> others;
    if (!o.html.empty()) {
        others.push_back({o.html, page});
    }
    tell_losses(write_look(matched_look(matched), o.output, others), o.output);
    o.json ? print(match_json(matched, o.output), shown)
           : print(match_text(matched, o.output), shown);
    return ok;
}

} // namespace

Run declare_match(Verb& verb) {
    const auto o = std::make_shared<MatchOptions>();
    verb.add_option("PICTURES", o->pictures,
                    "BEFORE AFTER: a picture and the same once it was graded, and more such pairs; "
                    "folders and patterns of frames (shot.####.png) are paired by name and number")
        .required();
    verb.add_output("-o,--output", o->output,
                    "a LUT file of any extension, or - for standard output")
        .required();
    verb.add_output("--html", o->html,
                    "a page of it too: which part of the colour cube the pictures show, and where "
                    "in them the look misses");
    verb.add_option("--size", o->size,
                    "nodes per axis (default: 33 or 32, whichever suits pixels better that were "
                    "held out; of charts 33)")
        .takes(Takes::cube_size);
    verb.add_option("--chart-before", o->chart_before,
                    "X,Y,WIDTH,HEIGHT of a ColorChecker in the picture before the grade, from the "
                    "outer edges of its outer patches, whichever way it lies: the look is learnt "
                    "from its 24 patches alone");
    verb.add_option("--chart-after", o->chart_after,
                    "the same in the picture after it; with one of the two, the published codes "
                    "stand for the other picture");
    verb.add_option("--frames", o->frames, "of a pattern: 1001-1100 or 1001-1100x2 (default: all)");
    verb.add_option("--before-encoding", o->before_encoding,
                    encoding_help("what the codes of BEFORE are") +
                        " (default: what its file says, else srgb)");
    verb.add_option("--after-encoding", o->after_encoding, "the same of AFTER");
    verb.add_option("--look-input", o->look_input,
                    "what the look shall take (default: BEFORE's codes; srgb where that holds "
                    "light)");
    verb.add_option("--look-output", o->look_output, "what it shall give, in the same way");
    verb.add_flag("--json", o->json, "print the results as JSON");
    return [o] { return run_match(*o); };
}

} // namespace converter
