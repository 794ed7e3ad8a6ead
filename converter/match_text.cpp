#include "converter/match_text.h"

#include "converter/report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
namespace {

// Share of the nodes about a corner of the cube.
constexpr double hardly_supported = 0.01;

std::string stats_text(const lutlib::ErrorStats& stats) {
    return fmt::format("mean {:.2f}, p99 {:.2f}, largest {:.2f}", stats.mean, stats.p99, stats.max);
}

std::string depth_text(int bits) {
    return bits ? fmt::format(", as a file of {} bits holds it", bits) : "";
}

std::string coverage_text(const lutlib::Coverage& coverage) {
    std::string out =
        fmt::format("  pixels support {:.1f} % of the nodes, and {:.1f} % stand within "
                    "two of such a one; {}\n",
                    100 * coverage.supported, 100 * coverage.near,
                    coverage.greys ? fmt::format("of the greys {:.2f} to {:.2f}",
                                                 (*coverage.greys)[0], (*coverage.greys)[1])
                                   : "none of the greys");
    std::string bare;
    for (const lutlib::CornerCoverage& corner : coverage.corners) {
        if (corner.supported < hardly_supported) {
            bare += (bare.empty() ? "" : ", ") + std::string(corner.name);
        }
    }
    if (!bare.empty()) {
        out += "  extrapolated, as less than 1 % of the nodes around these corners has pixels: " +
               bare + "\n";
    }
    return out;
}

nlohmann::ordered_json coverage_json(const lutlib::Coverage& coverage) {
    nlohmann::ordered_json corners;
    for (const lutlib::CornerCoverage& corner : coverage.corners) {
        corners[std::string(corner.name)] = corner.supported;
    }
    nlohmann::ordered_json out{
        {"supported", coverage.supported}, {"near", coverage.near}, {"greys", nullptr}};
    if (coverage.greys) {
        out["greys"] = *coverage.greys;
    }
    out["corners"] = corners;
    return out;
}

std::string source_text(const Matched& matched) {
    if (!matched.patches.empty()) {
        return "a chart of 24 patches";
    }
    return matched.pairs.size() == 1 ? input_text(matched.pairs[0].paths.before) + " and " +
                                           input_text(matched.pairs[0].paths.after)
                                     : fmt::format("{} pairs of pictures", matched.pairs.size());
}

std::string kind_text(const Matched& matched, const std::string& learnt_from) {
    return fmt::format("  {} nodes per axis, learnt from {}; {} to {}\n", matched.match.cube.size,
                       learnt_from, matched.look.input->name(), matched.look.output->name());
}

std::string pixels_text(const Matched& matched) {
    std::string out = kind_text(matched, fmt::format("{} pixels", matched.pixels));
    out += fmt::format("  dE2000 of the look on the picture{} from what was graded{}:\n",
                       matched.pairs.size() == 1 ? "" : "s", depth_text(matched.bits));
    out += "    all pixels: " + stats_text(matched.own) + "\n";
    if (!matched.held_out) {
        return out + "    nothing was held out: the pictures are too small\n";
    }
    out += fmt::format("    held out, {} pixels: {}\n", matched.held_out->count,
                       stats_text(*matched.held_out));
    if (matched.bits) {
        out += fmt::format("    (rounding to {} bits alone: mean {:.2f}, p99 {:.2f})\n",
                           matched.bits, matched.rounding.mean, matched.rounding.p99);
    }
    return out;
}

std::string patches_text(const Matched& matched) {
    const auto worst = [&](const lutlib::ErrorStats& stats) {
        return fmt::format("mean {:.2f}, largest {:.2f} ({})", stats.mean, stats.max,
                           matched.patches[stats.worst].name);
    };
    return kind_text(matched, "its patches") +
           "  dE2000 of the look at them: " + worst(matched.own) +
           "\n    of each by a look from the other 23: " + worst(*matched.held_out) + "\n";
}

} // namespace

std::string match_text(const Matched& matched, const std::string& output) {
    std::string out = fmt::format("{} <- {}\n", output_text(output), source_text(matched));
    out += matched.patches.empty() ? pixels_text(matched) : patches_text(matched);
    out += matched.patches.empty() ? coverage_text(matched.coverage) : "";
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
    for (const std::string& remark : matched.remarks) {
        out += "  " + one_line(remark) + "\n";
    }
    for (const MatchedPair& pair : matched.pairs) {
        const std::string name =
            matched.pairs.size() == 1 ? "" : input_text(pair.paths.after) + ": ";
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
        {"explained", matched.explained},
        {"bits", matched.bits},
        {"noise", 255 * matched.match.noise},
        {"all_pixels", {{"delta_e_2000", to_json(matched.own)}}},
        {"held_out", nullptr},
        {"coverage", coverage_json(matched.coverage)},
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
                                {"shift",
                                 {{"x", pair.shift.by.x},
                                  {"y", pair.shift.by.y},
                                  {"x_beyond", pair.shift.x_beyond},
                                  {"y_beyond", pair.shift.y_beyond},
                                  {"explained", pair.shift.explained}}},
                                {"delta_e_2000", to_json(pair.delta_e_2000)},
                                {"edits", pair.edits},
                                {"remarks", pair.remarks}});
    }
    out["patches"] = nlohmann::ordered_json::array();
    for (const MatchedPatch& patch : matched.patches) {
        out["patches"].push_back({{"name", patch.name},
                                  {"before", {patch.before.r, patch.before.g, patch.before.b}},
                                  {"after", {patch.after.r, patch.after.g, patch.after.b}},
                                  {"delta_e_2000", patch.off},
                                  {"delta_e_2000_left_out", patch.off_left_out}});
    }
    out["remarks"] = matched.remarks;
    return out;
}

} // namespace converter
