#include "converter/explain.h"

#include "lutlib/io/describe.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
namespace {

std::string remains(const lutlib::Lut& lut) {
    return lut.shaper || lut.cube ? lutlib::io::shape_of(lut) : "nothing: the identity";
}

} // namespace

Explanation explain(const lutlib::Lut& lut, double tolerance) {
    return {simplify(lut, {tolerance}), unreachable_nodes(lut), false, {}};
}

std::string to_text(const Explanation& explanation) {
    std::string out;
    for (const lutlib::Omission& omission : explanation.simplified.omissions) {
        out += fmt::format("  {}: {} (differs by at most {:.3g})\n",
                           explanation.left_out ? "left out" : "not needed", omission.words,
                           omission.bound);
    }
    if (out.empty()) {
        out = "  everything is needed\n";
    } else if (!explanation.kept.empty()) {
        out += "  kept: " + explanation.kept + "\n";
    } else {
        out += fmt::format("  {}: {}, equal within {:.3g}\n",
                           explanation.left_out ? "remains" : "would remain",
                           remains(explanation.simplified.lut), explanation.simplified.bound);
    }
    const lutlib::Unreachable& nodes = explanation.unreachable;
    if (nodes.nodes > 0) {
        out += fmt::format("  never reached: {} of {} nodes, by any input through the 1D table\n",
                           nodes.nodes, nodes.all);
    }
    if (nodes.of_engine > nodes.nodes) {
        out += fmt::format("  never reached: {} of {} nodes, by an engine that feeds 0..1\n",
                           nodes.of_engine, nodes.all);
    }
    return out;
}

nlohmann::ordered_json to_json(const Explanation& explanation) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const lutlib::Omission& omission : explanation.simplified.omissions) {
        list.push_back(
            {{"rule", omission.name}, {"words", omission.words}, {"bound", omission.bound}});
    }
    const lutlib::Unreachable& nodes = explanation.unreachable;
    nlohmann::ordered_json kept;
    if (!explanation.kept.empty()) {
        kept = explanation.kept;
    }
    return {{"not_needed", list},
            {"left_out", explanation.left_out},
            {"kept_because", kept},
            {"bound", explanation.simplified.bound},
            {"remains", remains(explanation.simplified.lut)},
            {"unreachable_nodes",
             {{"by_any_input", nodes.nodes}, {"by_0_1", nodes.of_engine}, {"of", nodes.all}}}};
}

} // namespace converter
