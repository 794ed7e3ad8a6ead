// lutconv encodings: the rows that every encoding's option takes, with their sources.
#include "converter/command.h"
#include "converter/listings.h"
#include "converter/report.h"
#include "lutlib/color/encoding.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>
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
    const auto json = std::make_shared<bool>(false);
    verb.add_flag("--json", *json, "print the rows as JSON, with chromaticities");
    return [json] {
        if (*json) {
            print(encodings_json(), "");
        } else {
            print(as_text(), "");
        }
        return static_cast<int>(ok);
    };
}

} // namespace converter
