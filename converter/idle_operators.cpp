#include "converter/idle_operators.h"

#include "converter/report.h"
#include "lutlib/io/file.h"
#include "lutlib/transform.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace converter {
namespace {

constexpr int trial_side = 33; // an operator may choose few hues
constexpr double trial_rounding = 1e-9;

std::vector<lutlib::RgbD> trial_colors(double low, double high) {
    std::vector<lutlib::RgbD> out;
    const auto at = [&](int i) { return low + (high - low) * i / (trial_side - 1); };
    for (int b = 0; b < trial_side; ++b) {
        for (int g = 0; g < trial_side; ++g) {
            for (int r = 0; r < trial_side; ++r) {
                out.push_back({at(r), at(g), at(b)});
            }
        }
    }
    return out;
}

bool stays_so(const lutlib::RgbD& a, const lutlib::RgbD& b) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(std::abs(a[c] - b[c]) <= trial_rounding * std::max(std::abs(b[c]), 1.0))) {
            return false;
        }
    }
    return true;
}

} // namespace

bool is_idle(const lutlib::Recipe& recipe, const lutlib::Operation& operation) {
    if (!operation.enabled || lutlib::is_identity(operation)) {
        return false;
    }
    lutlib::Recipe alone; // between the same encodings, which some operators ask about
    alone.input = recipe.input;
    alone.output = recipe.output;
    alone.adaptation = recipe.adaptation;
    const lutlib::Transform without = lutlib::Transform::of(alone);
    alone.operations = {operation};
    const lutlib::Transform with = lutlib::Transform::of(alone);
    constexpr std::array<std::array<double, 2>, 2> ranges{{{0, 1}, {-1, 8}}};
    return std::all_of(ranges.begin(), ranges.end(), [&](const std::array<double, 2>& range) {
        std::vector<lutlib::RgbD> changed = trial_colors(range[0], range[1]), kept = changed;
        with(changed);
        without(kept);
        return std::equal(changed.begin(), changed.end(), kept.begin(), stays_so);
    });
}

void tell_idle_operators(const lutlib::Recipe& recipe, std::size_t first) {
    for (std::size_t i = first; i < recipe.operations.size(); ++i) {
        if (is_idle(recipe, recipe.operations[i])) {
            print(fmt::format(
                      "lutconv: operator {} changes nothing here: with these values none of "
                      "{} colours tried changes\n",
                      recipe.operations[i].op->name, 2 * trial_side * trial_side * trial_side),
                  std::string(lutlib::io::standard_stream));
        }
    }
}

} // namespace converter
