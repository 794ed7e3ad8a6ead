#include "converter/listings.h"

#include "lutlib/color/encoding.h"
#include "lutlib/engine/engine.h"
#include "lutlib/io/formats.h"
#include "lutlib/named.h"
#include "lutlib/ops/op.h"

#include <nlohmann/json.hpp>

#include <string>
#include <variant>

namespace converter {
namespace {

using lutlib::Engine;
using nlohmann::ordered_json;

ordered_json row_of(const Engine& e) {
    return {{"name", e.name},
            {"label", e.label},
            {"layout", e.layout},
            {"size", e.default_size},
            {"sizes", e.sizes},
            {"usual_sizes", e.usual_sizes},
            {"bits", e.default_bits},
            {"accepted_bits", e.bits},
            {"srgb_tag", e.srgb_tag == lutlib::SrgbTag::present},
            {"encoding", e.encoding},
            {"input", e.input},
            {"import", e.import},
            {"lookup", e.lookup_help},
            {"source", e.source}};
}

std::string_view name_of(lutlib::ParameterKind kind) {
    switch (kind) {
    case lutlib::ParameterKind::number:
        return "number";
    case lutlib::ParameterKind::toggle:
        return "toggle";
    case lutlib::ParameterKind::rgb:
        return "rgb";
    case lutlib::ParameterKind::curve:
        break;
    }
    return "curve";
}

ordered_json default_of(const lutlib::Parameter& parameter) {
    const lutlib::Value value = default_value(parameter);
    if (const auto* const number = std::get_if<double>(&value)) {
        return *number;
    }
    if (const auto* const rgb = std::get_if<lutlib::RgbD>(&value)) {
        return {rgb->r, rgb->g, rgb->b};
    }
    return parameter.kind == lutlib::ParameterKind::curve
               ? ordered_json(parameter.axis.diagonal ? "y = x" : "constant")
               : ordered_json(parameter.automatic_words);
}

ordered_json row_of(const lutlib::Parameter& parameter) {
    ordered_json out{
        {"name", parameter.name},          {"flag", "--" + std::string(parameter.flag)},
        {"label", parameter.label},        {"kind", name_of(parameter.kind)},
        {"unit", parameter.unit},          {"range", {parameter.min, parameter.max}},
        {"default", default_of(parameter)}};
    if (parameter.kind == lutlib::ParameterKind::curve) {
        out["axis"] = {{"label", parameter.axis.label},
                       {"unit", parameter.axis.unit},
                       {"range", {parameter.axis.min, parameter.axis.max}},
                       {"periodic", parameter.axis.periodic}};
    }
    return out;
}

ordered_json row_of(const lutlib::Op& op) {
    ordered_json parameters = ordered_json::array();
    for (const lutlib::Parameter& parameter : op.parameters) {
        parameters.push_back(row_of(parameter));
    }
    return {{"name", op.name},           {"label", op.label},
            {"help", op.help},           {"space", name_of(op.space)},
            {"reference", op.reference}, {"parameters", parameters}};
}

ordered_json row_of(const lutlib::FileFormat& format) {
    ordered_json extensions = ordered_json::array();
    for (const std::string_view extension : format.extensions) {
        extensions.push_back(extension);
    }
    return {{"name", format.name},
            {"label", format.label},
            {"extensions", extensions},
            {"reads", format.read || format.read_in_pieces},
            {"writes", format.write != nullptr},
            {"curve", format.holds.curve},
            {"cube", format.holds.cube},
            {"curve_and_cube", format.holds.curve_and_cube},
            {"integer_bits", format.holds.integer_bits}};
}

template <class Rows>
ordered_json list_of(const Rows& rows) {
    ordered_json out = ordered_json::array();
    for (const auto& row : rows) {
        out.push_back(row_of(lutlib::row_of(row)));
    }
    return out;
}

} // namespace

ordered_json engines_json() {
    return list_of(lutlib::engines());
}

ordered_json encodings_json() {
    ordered_json curves = ordered_json::array(), gamuts = curves, adaptations = curves;
    for (const lutlib::TransferCurve* row : lutlib::transfer_curves()) {
        curves.push_back({{"name", row->name},
                          {"label", row->label},
                          {"gamut", row->gamut->name},
                          {"source", row->source}});
    }
    const auto xy = [](lutlib::Chromaticity c) { return ordered_json{c.x, c.y}; };
    for (const lutlib::Gamut* row : lutlib::gamuts()) {
        const lutlib::Primaries& p = row->primaries;
        gamuts.push_back({{"name", row->name},
                          {"label", row->label},
                          {"red", xy(p.red)},
                          {"green", xy(p.green)},
                          {"blue", xy(p.blue)},
                          {"white", xy(p.white)},
                          {"source", row->source}});
    }
    for (const lutlib::Adaptation* row : lutlib::adaptations()) {
        adaptations.push_back({{"name", row->name}, {"label", row->label}});
    }
    return {{"curves", curves}, {"gamuts", gamuts}, {"adaptations", adaptations}};
}

ordered_json operators_json() {
    return list_of(lutlib::ops());
}

ordered_json formats_json() {
    return list_of(lutlib::io::file_formats());
}

} // namespace converter
