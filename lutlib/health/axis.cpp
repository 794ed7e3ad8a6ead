#include "lutlib/health/axis.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

AxisCells straight(const Domain& domain, int size, std::size_t channel) {
    AxisCells cells(static_cast<std::size_t>(size - 1));
    const double min = domain.min[channel], max = domain.max[channel];
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double centre = (static_cast<double>(i) + 0.5) / (size - 1);
        cells[i] = {true, 1, std::lerp(min, max, centre), 1.0 / (size - 1)};
    }
    return cells;
}

// Every segment of the table, cut to the cube's domain and dealt out to the cells that it crosses.
AxisCells through(const Lut1D& shaper, const Domain& cube, int size, std::size_t c) {
    AxisCells cells(static_cast<std::size_t>(size - 1));
    const std::size_t segments = shaper.entries.size() - 1;
    const double cube_min = cube.min[c], cube_width = static_cast<double>(cube.max[c]) - cube_min;
    const double low = shaper.domain.min[c], high = shaper.domain.max[c];
    const bool rises = shaper.entries.back()[c] >= shaper.entries.front()[c];
    for (std::size_t k = 0; k < segments; ++k) {
        const double from = (static_cast<double>(shaper.entries[k][c]) - cube_min) / cube_width;
        const double to = (static_cast<double>(shaper.entries[k + 1][c]) - cube_min) / cube_width;
        if (!std::isfinite(from) || !std::isfinite(to)) {
            continue;
        }
        const double bottom = std::clamp(std::min(from, to), 0.0, 1.0);
        const double top = std::clamp(std::max(from, to), 0.0, 1.0);
        const bool moves = bottom < top;
        const double slope = moves ? std::abs(to - from) * static_cast<double>(segments) : 0;
        const double centre = (static_cast<double>(k) + 0.5) / static_cast<double>(segments);
        const auto last = static_cast<double>(cells.size() - 1);
        const auto first_cell = static_cast<std::size_t>(std::min(bottom * (size - 1), last));
        const auto last_cell = static_cast<std::size_t>(std::min(top * (size - 1), last));
        for (std::size_t i = first_cell; i <= last_cell; ++i) {
            AxisCell& cell = cells[i];
            const double cell_low = static_cast<double>(i) / (size - 1);
            const double cell_high = static_cast<double>(i + 1) / (size - 1);
            const double share = std::min(top, cell_high) - std::max(bottom, cell_low);
            // A segment that ends on a cell's edge only touches the next cell.
            if (moves && !(share > 0)) {
                continue;
            }
            if (!cell.reached || slope > cell.slope) {
                cell.slope = slope;
                cell.input = std::lerp(low, high, centre);
            }
            cell.reached = true;
            if (moves && (to > from) == rises) {
                cell.width += share / slope;
            }
        }
    }
    return cells;
}

double lowest_input(const Lut1D& shaper, std::size_t c, double wanted) {
    double nearest = INFINITY;
    int place = 0;
    for (int k = 0; k < shaper.size(); ++k) {
        const double own = shaper.entries[static_cast<std::size_t>(k)][c];
        if (std::abs(own - wanted) < nearest) {
            nearest = std::abs(own - wanted);
            place = k;
        }
        const double next =
            k + 1 < shaper.size()
                ? static_cast<double>(shaper.entries[static_cast<std::size_t>(k) + 1][c])
                : own;
        if (std::isfinite(next - own) && own != next && std::min(own, next) <= wanted &&
            wanted <= std::max(own, next)) {
            return std::lerp(entry_position(shaper, k)[c], entry_position(shaper, k + 1)[c],
                             (wanted - own) / (next - own));
        }
    }
    return entry_position(shaper, place)[c];
}

} // namespace

std::array<AxisCells, 3> cells_of_axes(const Lut& lut, int size, const Domain& cube_domain) {
    std::array<AxisCells, 3> out;
    for (std::size_t c = 0; c < 3; ++c) {
        out[c] = lut.shaper ? through(*lut.shaper, cube_domain, size, c)
                            : straight(cube_domain, size, c);
    }
    return out;
}

std::array<std::vector<double>, 3> inputs_of_nodes(const Lut& lut, const Lut3D& cube) {
    std::array<std::vector<double>, 3> out;
    for (int i = 0; i < cube.size; ++i) {
        const RgbD position = node_position(cube, i, i, i);
        for (std::size_t c = 0; c < 3; ++c) {
            out[c].push_back(lut.shaper ? lowest_input(*lut.shaper, c, position[c]) : position[c]);
        }
    }
    return out;
}

} // namespace lutlib
