// Tables and neutrals that fall where they should rise.
#include "lutlib/color/luma.h"
#include "lutlib/health/parts.h"
#include "lutlib/health/repair_parts.h"
#include "lutlib/nodes.h"
#include "lutlib/rising.h"

#include <algorithm>
#include <cmath>

namespace lutlib::health {

std::string straighten_table(Lut& lut, const RepairOptions& /*options*/) {
    bool done = false;
    for (std::size_t c = 0; lut.shaper && c < 3; ++c) {
        auto& e = lut.shaper->entries;
        const double sense = e.back()[c] >= e.front()[c] ? 1 : -1;
        std::vector<double> values;
        for (const Rgb& entry : e) {
            values.push_back(sense * static_cast<double>(entry[c]));
        }
        if (std::is_sorted(values.begin(), values.end())) {
            continue;
        }
        done = true;
        const std::vector<double> straight = rising(values);
        for (std::size_t i = 0; i < e.size(); ++i) {
            e[i][c] = static_cast<float>(sense * straight[i]);
        }
    }
    return done ? "the 1D table is monotonic" : "";
}

namespace {

// Chroma, as a share of the cube's width, up to which a neutral's correction is carried outwards.
constexpr double carried = 0.25;

} // namespace

// The same amount is added to all channels, so that no neutral changes its hue; it fades with the
// distance from the neutral axis, so that no step appears beside it.
std::string straighten_neutrals(Lut& lut, const RepairOptions& /*options*/) {
    if (!lut.cube) {
        return "";
    }
    Lut3D& cube = *lut.cube;
    std::vector<double> values;
    for (int i = 0; i < cube.size; ++i) {
        values.push_back(luma(to_double(cube.at(i, i, i))));
    }
    double highest = values.front(), fall = 0;
    for (const double v : values) {
        fall = std::max(fall, highest - v);
        highest = std::max(highest, v);
    }
    // Less is no fault; and a negative is meant to fall.
    if (fall <= std::max(fall_warning, rounding_of(lut)) || values.back() <= values.front()) {
        return "";
    }
    const std::vector<double> straight = rising(values);
    const OutputRange range = finite_range(cube.nodes);
    const double last = cube.size - 1;
    for_each_node(cube.size, [&](int r, int g, int b) {
        const auto [low, high] = std::minmax({r, g, b});
        const double chroma = (high - low) / last;
        if (chroma >= carried) {
            return;
        }
        const double level = (r + g + b) / 3.0;
        const auto i = std::min(static_cast<std::size_t>(level), values.size() - 2);
        const double t = level - static_cast<double>(i);
        const double shift = std::lerp(straight[i] - values[i], straight[i + 1] - values[i + 1], t);
        const double u = 1 - chroma / carried;
        const double added = shift * u * u * (3 - 2 * u);
        Rgb& node = cube.at(r, g, b);
        for (std::size_t c = 0; c < 3; ++c) {
            // A repair gives no values that the look did not.
            node[c] = static_cast<float>(
                std::clamp(static_cast<double>(node[c]) + added, range.low, range.high));
        }
    });
    return "brighter neutrals no longer become darker";
}

} // namespace lutlib::health
