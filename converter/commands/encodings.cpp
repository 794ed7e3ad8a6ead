// lutconv encodings: the rows that every encoding's option takes, with their sources.
#include "converter/listing_verb.h"
#include "converter/listings.h"
#include "lutlib/color/encoding.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <string>

namespace converter {
namespace {

terminal::Table encodings_table() {
    terminal::Table out;
    const auto add = [&](std::string_view name, const std::string& label, std::string_view source) {
        out.row({std::string(name), label, std::string(source)});
    };
    out.heading("curves, each with the gamut that its name alone implies");
    for (const lutlib::TransferCurve* row : lutlib::transfer_curves()) {
        add(row->name, fmt::format("{}, {}", row->label, row->gamut->name), row->source);
    }
    out.heading("gamuts, as curve/gamut");
    for (const lutlib::Gamut* row : lutlib::gamuts()) {
        add(row->name, std::string(row->label), row->source);
    }
    out.heading("adaptations between whites");
    for (const lutlib::Adaptation* row : lutlib::adaptations()) {
        add(row->name, std::string(row->label), row->source);
    }
    return out;
}

} // namespace

Run declare_encodings(Verb& verb) {
    return declare_listing(verb, "chromaticities", encodings_table, encodings_json);
}

} // namespace converter
