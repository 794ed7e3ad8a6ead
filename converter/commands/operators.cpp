// lutconv operators: what recipes and edit are made of.
#include "converter/listing_verb.h"
#include "converter/listings.h"
#include "lutlib/ops/op.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <string>

namespace converter {
namespace {

using lutlib::Parameter;
using lutlib::ParameterKind;

std::string range_text(const Parameter& p) {
    if (p.kind == ParameterKind::toggle) {
        return "on or off";
    }
    const std::string numbers =
        fmt::format("{:g} to {:g}{}{}", p.min, p.max, p.unit.empty() ? "" : " ", p.unit);
    return p.kind == ParameterKind::rgb ? numbers + ", or three"
           : p.kind == ParameterKind::curve
               ? fmt::format("curve of {} over {:g} to {:g} {}", numbers, p.axis.min, p.axis.max,
                             p.axis.unit)
               : numbers;
}

terminal::Table operators_table() {
    terminal::Table out;
    for (const lutlib::Op* const op : lutlib::ops()) {
        out.row({std::string(op->name), std::string(op->help)});
        for (const Parameter& p : op->parameters) {
            out.row({fmt::format("  --{}", p.flag), range_text(p)});
        }
    }
    return out;
}

} // namespace

Run declare_operators(Verb& verb) {
    return declare_listing(verb, "defaults and formulas", operators_table, operators_json);
}

} // namespace converter
