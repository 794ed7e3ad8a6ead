#include "preview/finish/scope_levels.h"

#include "lutlib/color/transfer_constants.h"
#include "preview/finish/scopes.h"

#include <fmt/format.h>

#include <algorithm>

namespace preview {

namespace {

/// What the heights of an encoding's codes are told as.
struct LevelUnit {
    std::string_view curve; ///< empty: every other curve
    std::string_view unit;
};
constexpr std::array<LevelUnit, 3> units{{
    {"pq", "cd/m2"},
    {"linear", "of diffuse white"},
    {"", "%"},
}};
constexpr const LevelUnit &pq = units[0], &linear = units[1];

const LevelUnit& unit_of(const ScopeLevels& levels) {
    const std::string_view curve = levels.encoding ? levels.encoding->curve->name : "";
    return *std::find_if(units.begin(), units.end(), [&](const LevelUnit& row) {
        return row.curve == curve || row.curve.empty();
    });
}

bool is_pq(const lutlib::Encoding& encoding) {
    return encoding.curve->name == pq.curve;
}

std::string number(double value) {
    return value < 100 ? fmt::format("{:.3g}", value) : fmt::format("{:.0f}", value);
}

} // namespace

LevelScale level_scale(const ScopeLevels& levels) {
    if (!levels.converts()) {
        return {};
    }
    const double of_white = static_cast<double>(levels.white) / lutlib::pq_white_nits;
    LevelScale out;
    out.factor =
        (is_pq(levels.shown) ? 1 / of_white : 1) * (is_pq(*levels.encoding) ? of_white : 1);
    if (&unit_of(levels) == &linear) {
        out.top = std::max(1.0, out.factor * levels.shown.decode(1));
    }
    return out;
}

std::vector<LevelFigure> level_figures(const ScopeLevels& levels) {
    std::vector<LevelFigure> out;
    const LevelUnit& unit = unit_of(levels);
    if (&unit == &pq) {
        for (const double luminance : {0.1, 1.0, 10.0, 100.0, 1000.0, 10000.0}) {
            out.push_back(
                {number(luminance), levels.encoding->encode(luminance / lutlib::pq_white_nits)});
        }
        return out;
    }
    for (const double quarter : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        out.push_back({number(level_value(levels, quarter)), quarter});
    }
    return out;
}

const std::vector<LevelFigure>& percent_figures() {
    static const std::vector<LevelFigure> figures = level_figures({});
    return figures;
}

double level_value(const ScopeLevels& levels, double share) {
    const LevelUnit& unit = unit_of(levels);
    return &unit == &pq       ? lutlib::pq_white_nits * levels.encoding->decode(share)
           : &unit == &linear ? level_scale(levels).top * share
                              : 100 * share;
}

std::string_view level_unit(const ScopeLevels& levels) {
    return unit_of(levels).unit;
}

std::string levels_text(const ScopeLevels& levels) {
    const std::string shown = levels.shown.name();
    if (!levels.encoding) {
        return "levels are the codes as they are shown, in per cent";
    }
    std::string out = fmt::format("levels are {}", levels.encoding->name());
    out += levels.converts() ? fmt::format(" of the shown {}", shown) : ", as it is shown";
    if (levels.converts() && (is_pq(*levels.encoding) != is_pq(levels.shown))) {
        out += fmt::format(", the display's white at {:.4g} cd/m2", levels.white);
    }
    return out + fmt::format("; figures are {}",
                             unit_of(levels).unit == "%" ? "per cent" : unit_of(levels).unit);
}

std::optional<lutlib::Encoding> shown_codes(const ScopeSide& side, const Compare& compare,
                                            const std::array<lutlib::Encoding, 2>& sides) {
    const bool has_a = compare.shows_a && &side != &scope_sides[2];
    const bool has_b = compare.shows_b && &side != &scope_sides[1];
    if (has_a && has_b && sides[0] != sides[1]) {
        return std::nullopt;
    }
    return has_b ? sides[1] : sides[0];
}

std::string mixed_codes_text(const std::array<lutlib::Encoding, 2>& sides) {
    return fmt::format("measure side a or b alone: A shows {} and B {}, and both are read as {}",
                       sides[0].name(), sides[1].name(), lutlib::srgb().name());
}

} // namespace preview
