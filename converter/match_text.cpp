#include "converter/match_text.h"

#include "converter/report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
namespace {

std::string stats_text(const lutlib::ErrorStats& stats) {
    return fmt::format("mean {:.2f}, p99 {:.2f}, largest {:.2f}", stats.mean, stats.p99, stats.max);
}

std::string depth_text(int bits) {
    return bits ? fmt::format(", as a file of {} bits holds it", bits) : "";
}

} // namespace

std::string match_text(const Matched& matched, const std::string& output) {
    const bool one = matched.pairs.size() == 1;
    std::string out = fmt::format("{} <- {}\n", output_text(output),
                                  one ? input_text(matched.pairs[0].paths.before) + " and " +
                                            input_text(matched.pairs[0].paths.after)
                                      : fmt::format("{} pairs of pictures", matched.pairs.size()));
    out += fmt::format("  {} nodes per axis, learnt from {} pixels; {} to {}\n",
                       matched.match.cube.size, matched.pixels, matched.look.input->name(),
                       matched.look.output->name());
    out += fmt::format("  dE2000 of the look on {} from what was graded{}:\n",
                       one ? "the picture" : "the pictures", depth_text(matched.bits));
    out += "    all pixels: " + stats_text(matched.own) + "\n";
    if (matched.held_out) {
        out += fmt::format("    held out, {} pixels: {}\n", matched.held_out->count,
                           stats_text(*matched.held_out));
        if (matched.bits) {
            out += fmt::format("    (rounding to {} bits alone: mean {:.2f}, p99 {:.2f})\n",
                               matched.bits, matched.rounding.mean, matched.rounding.p99);
        }
    } else {
        out += "    nothing was held out: the pictures are too small\n";
    }
    for (std::size_t c = 0; c < 3; ++c) {
        if (matched.match.greys_fall[c]) {
            out += fmt::format("  {} falls along the greys, as it does in the pictures\n",
                               c == 0   ? "red"
                               : c == 1 ? "green"
                                        : "blue");
        }
    }
    if (matched.left_out > 0) {
        out += fmt::format("  {} pixels in places that were edited by themselves were left out\n",
                           matched.left_out);
    }
    for (const MatchedPair& pair : matched.pairs) {
        const std::string name = one ? "" : input_text(pair.paths.after) + ": ";
        for (const std::string& edit : pair.edits) {
            out += "  " + name + one_line(edit) + "\n";
        }
        for (const std::string& remark : pair.remarks) {
            out += "  " + one_line(remark) + "\n";
        }
    }
    return out;
}

nlohmann::ordered_json match_json(const Matched& matched, const std::string& output) {
    nlohmann::ordered_json out{
        {"output", output},
        {"size", matched.match.cube.size},
        {"look_input", matched.look.input->name()},
        {"look_output", matched.look.output->name()},
        {"pixels", matched.pixels},
        {"left_out", matched.left_out},
        {"bits", matched.bits},
        {"noise", 255 * matched.match.noise},
        {"all_pixels", {{"delta_e_2000", to_json(matched.own)}}},
        {"held_out", nullptr},
        {"greys_fall",
         {matched.match.greys_fall[0], matched.match.greys_fall[1], matched.match.greys_fall[2]}}};
    if (matched.held_out) {
        out["held_out"] = {{"delta_e_2000", to_json(*matched.held_out)},
                           {"rounding_delta_e_2000", to_json(matched.rounding)}};
    }
    out["pairs"] = nlohmann::ordered_json::array();
    for (const MatchedPair& pair : matched.pairs) {
        out["pairs"].push_back({{"before", pair.paths.before},
                                {"after", pair.paths.after},
                                {"width", pair.size.width},
                                {"height", pair.size.height},
                                {"delta_e_2000", to_json(pair.delta_e_2000)},
                                {"edits", pair.edits},
                                {"remarks", pair.remarks}});
    }
    return out;
}

} // namespace converter
