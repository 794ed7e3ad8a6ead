#include "lutlib/metrics/error_samples.h"

#include "lutlib/metrics/samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace lutlib {
namespace {

using Axes = UnionAxes;

constexpr std::size_t neutrals = 256;
// A map of which nothing is known is looked at as if it had nodes here.
constexpr int nodes_of_the_unknown = 33;

std::vector<float> axis_over(float min, float max, const std::vector<double>& breaks, bool all) {
    constexpr float same_input = 1e-6F;
    std::vector<float> out{min};
    const auto append = [&](double value) {
        const auto x = static_cast<float>(value);
        if (x > min && x < max) {
            out.push_back(x);
        }
    };
    std::for_each(breaks.begin(), breaks.end(), append);
    const bool unknown = !all && out.size() == 1;
    for (int i = 1; unknown && i + 1 < nodes_of_the_unknown; ++i) {
        append(std::lerp(static_cast<double>(min), static_cast<double>(max),
                         static_cast<double>(i) / (nodes_of_the_unknown - 1)));
    }
    out.push_back(max);
    const auto same = [&](float a, float b) { return b - a <= same_input * (max - min); };
    out.erase(std::unique(out.begin(), out.end() - 1, same), out.end() - 1);
    while (out.size() > 2 && same(out[out.size() - 2], max)) {
        out.erase(out.end() - 2);
    }
    return out;
}

std::size_t product(const Axes& axis) {
    return axis[0].size() * axis[1].size() * axis[2].size();
}

// Which of `count` a place in 0..1 falls on.
std::size_t chosen(float place, std::size_t count) {
    return std::min(static_cast<std::size_t>(place * static_cast<float>(count)), count - 1);
}

void append_grid(std::vector<Rgb>& out, const Axes& axis) {
    for (const float b : axis[2]) {
        for (const float g : axis[1]) {
            for (const float r : axis[0]) {
                out.push_back({r, g, b});
            }
        }
    }
}

// Places of 0..1, evenly.
std::vector<Rgb> spread(std::size_t count, std::size_t skipped = 0) {
    std::vector<Rgb> out = sample_colors(2, {.neutral = 0,
                                             .random = static_cast<int>(count),
                                             .lattice = false,
                                             .skipped = static_cast<int>(skipped)});
    out.erase(out.begin(), out.begin() + 8);
    return out;
}

// A number of -0.5..0.5 that is the same on every machine (the finaliser of MurmurHash3).
float scattered(std::uint32_t i) {
    i ^= i >> 16;
    i *= 0x85ebca6bU;
    i ^= i >> 13;
    i *= 0xc2b2ae35U;
    i ^= i >> 16;
    return static_cast<float>(i >> 8) * 0x1p-24F - 0.5F;
}

// The sequence alone is in step with what some pairs of lattices differ by, and a percentile of
// 50,000 colours may be 7 % wrong. So each is moved within its share of the cube.
std::vector<Rgb> out_of_step(std::vector<Rgb> places) {
    const float share = 1 / std::cbrt(static_cast<float>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float moved =
                places[i][c] + share * scattered(static_cast<std::uint32_t>(3 * i + c));
            places[i][c] = std::clamp(moved - std::floor(moved), 0.0F, 1.0F);
        }
    }
    return places;
}

// Colours of a grid, evenly.
void append_chosen(std::vector<Rgb>& out, const Axes& axis, std::size_t count) {
    for (const Rgb& place : spread(count)) {
        out.push_back({axis[0][chosen(place.r, axis[0].size())],
                       axis[1][chosen(place.g, axis[1].size())],
                       axis[2][chosen(place.b, axis[2].size())]});
    }
}

// A part of a grid that is too large: its ends, and an even choice of what lies between.
void append_part(std::vector<Rgb>& out, const Axes& axis, std::size_t most) {
    const auto color = [&](std::size_t r, std::size_t g, std::size_t b) {
        return Rgb{axis[0][r], axis[1][g], axis[2][b]};
    };
    const std::array<std::size_t, 3> last{axis[0].size() - 1, axis[1].size() - 1,
                                          axis[2].size() - 1};
    const std::size_t share = most / 4;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t step = 1 + 12 * axis[c].size() / share;
        for (std::size_t i = 0; i <= last[c]; i += step) {
            for (std::size_t end = 0; end < 4; ++end) {
                std::array<std::size_t, 3> at{};
                at[c] = i;
                at[(c + 1) % 3] = end & 1 ? last[(c + 1) % 3] : 0;
                at[(c + 2) % 3] = end & 2 ? last[(c + 2) % 3] : 0;
                out.push_back(color(at[0], at[1], at[2]));
            }
        }
    }
    for (const Rgb& place : spread(share)) {
        const std::size_t face = chosen(place.b, 6), c = face / 2;
        std::array<std::size_t, 3> at{};
        at[c] = face & 1 ? last[c] : 0;
        at[(c + 1) % 3] = chosen(place.r, axis[(c + 1) % 3].size());
        at[(c + 2) % 3] = chosen(place.g, axis[(c + 2) % 3].size());
        out.push_back(color(at[0], at[1], at[2]));
    }
    append_chosen(out, axis, most - 2 * share);
}

bool is_middle(std::size_t r, std::size_t g, std::size_t b) {
    return (r | g | b) & 1;
}

// Those of a grid of breaks and middles on the domain's faces, where looks are strongest.
void append_middles_of_faces(std::vector<Rgb>& out, const Axes& fine, std::size_t most) {
    const auto append = [&](std::size_t c, std::size_t end, std::size_t i, std::size_t j) {
        std::array<std::size_t, 3> at{};
        at[c] = end;
        at[(c + 1) % 3] = i;
        at[(c + 2) % 3] = j;
        if (is_middle(at[0], at[1], at[2])) {
            out.push_back({fine[0][at[0]], fine[1][at[1]], fine[2][at[2]]});
        }
    };
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t wide = fine[(c + 1) % 3].size(), high = fine[(c + 2) % 3].size();
        const bool fits = 6 * wide * high <= most;
        for (const std::size_t end : {std::size_t{0}, fine[c].size() - 1}) {
            for (std::size_t j = 0; fits && j < high; ++j) {
                for (std::size_t i = 0; i < wide; ++i) {
                    append(c, end, i, j);
                }
            }
            for (const Rgb& place : spread(fits ? 0 : most / 6)) {
                append(c, end, chosen(place.r, wide), chosen(place.g, high));
            }
        }
    }
}

// Each channel's breaks and the middles between them; a colour has one middle at least. Whether
// these are all.
bool append_between(std::vector<Rgb>& out, const Axes& axis, std::size_t most) {
    Axes fine, middles;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i + 1 < axis[c].size(); ++i) {
            middles[c].push_back(std::midpoint(axis[c][i], axis[c][i + 1]));
            fine[c].insert(fine[c].end(), {axis[c][i], middles[c].back()});
        }
        fine[c].push_back(axis[c].back());
    }
    if (product(fine) - product(axis) <= most) {
        for (std::size_t b = 0; b < fine[2].size(); ++b) {
            for (std::size_t g = 0; g < fine[1].size(); ++g) {
                for (std::size_t r = 0; r < fine[0].size(); ++r) {
                    if (is_middle(r, g, b)) {
                        out.push_back({fine[0][r], fine[1][g], fine[2][b]});
                    }
                }
            }
        }
        return true;
    }
    // Interpolations that agree on nodes, edges and faces differ most within a cell.
    if (product(middles) <= most) {
        append_grid(out, middles);
    } else {
        append_chosen(out, middles, most);
    }
    append_middles_of_faces(out, fine, most / 2);
    for (const Rgb& place : spread(most / 8)) {
        const std::size_t r = chosen(place.r, fine[0].size()), g = chosen(place.g, fine[1].size()),
                          b = chosen(place.b, fine[2].size());
        if (is_middle(r, g, b)) {
            out.push_back({fine[0][r], fine[1][g], fine[2][b]});
        }
    }
    return false;
}

// Grey codes at every coordinate of any channel, and evenly.
void append_neutrals(std::vector<Rgb>& out, const Domain& domain, const Axes& axis) {
    for (std::size_t i = 0; i <= neutrals; ++i) {
        const float t = static_cast<float>(i) / neutrals;
        out.push_back({std::lerp(domain.min.r, domain.max.r, t),
                       std::lerp(domain.min.g, domain.max.g, t),
                       std::lerp(domain.min.b, domain.max.b, t)});
    }
    const float low = std::max({domain.min.r, domain.min.g, domain.min.b});
    const float high = std::min({domain.max.r, domain.max.g, domain.max.b});
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t step = 1 + axis[c].size() / (4 * neutrals);
        for (std::size_t i = 0; i < axis[c].size(); i += step) {
            const float x = axis[c][i];
            if (x >= low && x <= high) {
                out.push_back({x, x, x});
            }
        }
    }
}

} // namespace

std::vector<Rgb> even_samples(const Domain& domain, std::size_t count) {
    return over_domain(out_of_step(spread(count)), domain);
}

UnionAxes union_axes(const Domain& domain, const Breaks& breaks) {
    UnionAxes out;
    for (std::size_t c = 0; c < 3; ++c) {
        out[c] = axis_over(domain.min[c], domain.max[c], breaks.at[c], breaks.all);
    }
    return out;
}

ErrorSamples error_samples(const Domain& domain, const Breaks& breaks, const SampleLimits& limits) {
    ErrorSamples out;
    out.domain = domain;
    out.even = even_samples(domain, limits.even);
    out.axis = union_axes(domain, breaks);
    const bool fits = product(out.axis) <= limits.grid;
    out.whole = breaks.all && fits;
    if (fits) {
        append_grid(out.hiding, out.axis);
    } else {
        append_part(out.hiding, out.axis, limits.grid);
    }
    const bool all = append_between(out.hiding, out.axis, limits.between);
    constexpr std::size_t scanned_grids = 8, middles_of_cell = 19;
    if (product(out.axis) <= scanned_grids * limits.grid) {
        out.suspects = {all ? 0 : limits.between / middles_of_cell / 4,
                        fits ? 0 : limits.between / 8};
    }
    append_neutrals(out.hiding, domain, out.axis);
    return out;
}

} // namespace lutlib
