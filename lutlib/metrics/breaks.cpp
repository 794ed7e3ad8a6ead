#include "lutlib/metrics/breaks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

// Entries of a longer table before a cube are samples of a smooth curve.
constexpr int short_table = 65;

double along(double min, double max, double place, int size) {
    return min + place / (size - 1) * (max - min);
}

// Inputs nearer to each other than this share of the domain are one.
constexpr double same_input = 1e-6;

// Both sides of it.
void append_jump(std::vector<double>& out, double at, double width) {
    constexpr double beside = 1e-5;
    out.push_back(at - beside * width);
    out.push_back(at + beside * width);
}

// Where the cube's channel is at its nodes; where it jumps, both sides of a jump.
std::vector<double> cube_breaks(const Lut3D& cube, std::size_t channel, Interpolation how) {
    const double min = cube.domain.min[channel], max = cube.domain.max[channel];
    std::vector<double> out;
    for (int i = 0; i < cube.size; ++i) {
        out.push_back(along(min, max, i, cube.size));
        if (how == Interpolation::nearest && i + 1 < cube.size) {
            append_jump(out, along(min, max, i + 0.5, cube.size), max - min);
        }
    }
    return out;
}

// The inputs that a table's channel maps to the wanted values, which rise.
void append_origins(std::vector<double>& out, const Lut1D& table, std::size_t channel,
                    const std::vector<double>& wanted) {
    for (int i = 0; i + 1 < table.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double from = table.entries[k][channel], to = table.entries[k + 1][channel];
        const double x = entry_position(table, i)[channel],
                     next = entry_position(table, i + 1)[channel];
        const auto first = std::lower_bound(wanted.begin(), wanted.end(), std::min(from, to));
        for (auto w = first; w != wanted.end() && *w <= std::max(from, to); ++w) {
            out.push_back(from == to ? x : x + (*w - from) / (to - from) * (next - x));
        }
    }
}

void tidy(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    const double width = values.empty() ? 0 : values.back() - values.front();
    const auto same = [width](double a, double b) { return b - a <= same_input * width; };
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
}

} // namespace

Breaks breaks_of(const Lut& look, Interpolation how) {
    Breaks out;
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double>& at = out.at[c];
        if (look.cube) {
            at = cube_breaks(*look.cube, c, how);
        }
        if (!look.shaper) {
            continue;
        }
        const Lut1D& table = *look.shaper;
        const std::vector<double> wanted = std::exchange(at, {});
        append_origins(at, table, c, wanted);
        if (!look.cube || table.size() <= short_table) {
            for (int i = 0; i < table.size(); ++i) {
                at.push_back(entry_position(table, i)[c]);
            }
        } else {
            at.insert(at.end(), {table.domain.min[c], table.domain.max[c]});
            out.all = false;
        }
        tidy(at);
    }
    return out;
}

Breaks breaks_of(const Lut& look) {
    return breaks_of(look, usual_interpolation(look));
}

Breaks breaks_of(const LatticeReader& reader) {
    Breaks out;
    for (std::size_t c = 0; c < 3; ++c) {
        const double min = reader.domain.min[c], max = reader.domain.max[c];
        std::vector<double>& at = out.at[c];
        at = {min, max};
        // A reader of texel centres stays at its first node for half a texel.
        constexpr double just_inside = 1e-9;
        at.push_back(reader.input_at(c, just_inside));
        for (int i = 1; i < reader.size; ++i) {
            at.push_back(reader.input_at(c, i));
        }
        if (reader.how == Interpolation::nearest) {
            for (int i = 0; i + 1 < reader.size; ++i) {
                append_jump(at, reader.input_at(c, i + 0.5), max - min);
            }
        }
        tidy(at);
    }
    return out;
}

Breaks no_breaks() {
    return {{}, false};
}

Breaks united(const Breaks& a, const Breaks& b) {
    Breaks out = a;
    out.all = a.all && b.all;
    for (std::size_t c = 0; c < 3; ++c) {
        out.at[c].insert(out.at[c].end(), b.at[c].begin(), b.at[c].end());
        tidy(out.at[c]);
    }
    return out;
}

} // namespace lutlib
