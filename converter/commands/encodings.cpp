// lutconv encodings: the rows that every encoding's option takes, with their sources.
#include "converter/listing_verb.h"
#include "converter/listings.h"
#include "lutlib/color/encoding.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <string>

namespace converter {
namespace {

std::string line(std::string_view name, std::string_view label, std::string_view source) {
    return fmt::format("  {:21} {:47} {}\n", name, label, source);
}

std::string as_text() {
    std::string out = "curves, each with the gamut that its name alone implies\n";
    for (const lutlib::TransferCurve* row : lutlib::transfer_curves()) {
        out += line(row->name, fmt::format("{}, {}", row->label, row->gamut->name), row->source);
    }
    out += "gamuts, as curve/gamut\n";
    for (const lutlib::Gamut* row : lutlib::gamuts()) {
        out += line(row->name, row->label, row->source);
    }
    out += "adaptations between whites\n";
    for (const lutlib::Adaptation* row : lutlib::adaptations()) {
        out += line(row->name, row->label, row->source);
    }
    return out;
}

} // namespace

Run declare_encodings(Verb& verb) {
    return declare_listing(verb, "chromaticities", as_text, encodings_json);
}

} // namespace converter
