#include "lutlib/resample/simplify.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lutlib {
namespace {

double distance(const Rgb& a, const Rgb& b) {
    return largest_magnitude(to_double(a) - to_double(b));
}

// Inputs outside the domain are clamped to it: the identity only of what lies inside. That is said.
Omission drop_identity_cube(Lut& lut, double tolerance) {
    if (!lut.cube) {
        return {};
    }
    double bound = 0;
    for_each_node(lut.cube->size, [&](int r, int g, int b) {
        bound = std::max(bound, largest_magnitude(to_double(lut.cube->at(r, g, b)) -
                                                  node_position(*lut.cube, r, g, b)));
    });
    // After a 1D table the cube also clamps; it goes only where the table stays within its domain.
    for (std::size_t i = 0; lut.shaper && i < lut.shaper->entries.size(); ++i) {
        const Rgb& entry = lut.shaper->entries[i];
        for (std::size_t c = 0; c < 3; ++c) {
            const float held =
                std::clamp(entry[c], lut.cube->domain.min[c], lut.cube->domain.max[c]);
            if (held != entry[c]) {
                return {};
            }
        }
    }
    if (bound > tolerance) {
        return {};
    }
    const bool alone = !lut.shaper;
    lut.cube.reset();
    return {"",
            alone ? "the look is the identity over its domain: it need not be applied"
                  : "the cube is the identity: the 1D table alone is the look",
            bound};
}

Omission drop_identity_curve(Lut& lut, double tolerance) {
    if (!lut.shaper || lut.cube) {
        return {};
    }
    double bound = 0;
    for (int i = 0; i < lut.shaper->size(); ++i) {
        bound = std::max(
            bound, largest_magnitude(to_double(lut.shaper->entries[static_cast<std::size_t>(i)]) -
                                     entry_position(*lut.shaper, i)));
    }
    if (bound > tolerance) {
        return {};
    }
    lut.shaper.reset();
    return {"", "the look is the identity over its domain: it need not be applied", bound};
}

// The steepest edge of the cube along each input channel, in output per width of its domain.
RgbD steepest_edges(const Lut3D& cube) {
    RgbD out;
    for_each_node(cube.size, [&](int r, int g, int b) {
        const std::array<int, 3> at{r, g, b};
        for (std::size_t c = 0; c < 3; ++c) {
            if (at[c] + 1 < cube.size) {
                std::array<int, 3> next = at;
                ++next[c];
                out[c] = std::max(out[c],
                                  distance(cube.at(next[0], next[1], next[2]), cube.at(r, g, b)) *
                                      (cube.size - 1));
            }
        }
    });
    return out;
}

// A straight 1D table only stretches the input: the cube's domain can say that. The table's clamp
// must not bite before the cube's does, so its values must span the cube's whole domain.
Omission fold_linear_shaper(Lut& lut, double tolerance) {
    if (!lut.shaper || !lut.cube) {
        return {};
    }
    const Lut1D& shaper = *lut.shaper;
    const Domain& cube = lut.cube->domain;
    Domain folded;
    for (std::size_t c = 0; c < 3; ++c) {
        const double y0 = shaper.entries.front()[c], y1 = shaper.entries.back()[c];
        const double x0 = shaper.domain.min[c], x1 = shaper.domain.max[c];
        if (!(y1 > y0)) {
            return {};
        }
        const auto input = [&](float y) {
            return static_cast<float>(x0 + (static_cast<double>(y) - y0) * (x1 - x0) / (y1 - y0));
        };
        folded.min[c] = input(cube.min[c]);
        folded.max[c] = input(cube.max[c]);
        if (!(folded.min[c] < folded.max[c]) || !std::isfinite(folded.max[c] - folded.min[c])) {
            return {};
        }
    }
    // Both look up the cube at a place that is straight between the table's entries, once clamped
    // to its domain; how far those places differ, times the cube's steepest slope, bounds the rest.
    const auto place = [](double value, float min, float max) {
        const double width = static_cast<double>(max) - static_cast<double>(min);
        return std::clamp((value - static_cast<double>(min)) / width, 0.0, 1.0);
    };
    const auto unclamped = [](double value, float min, float max) {
        return (value - static_cast<double>(min)) /
               (static_cast<double>(max) - static_cast<double>(min));
    };
    RgbD apart;
    for (std::size_t c = 0; c < 3; ++c) {
        for (int i = 0; i < shaper.size(); ++i) {
            const double x = entry_position(shaper, i)[c];
            const double y = shaper.entries[static_cast<std::size_t>(i)][c];
            apart[c] = std::max(apart[c], std::abs(unclamped(y, cube.min[c], cube.max[c]) -
                                                   unclamped(x, folded.min[c], folded.max[c])));
        }
        // Beyond the table's ends it stands still; so must the folded domain, within the bound.
        const double low = place(shaper.entries.front()[c], cube.min[c], cube.max[c]);
        const double high = place(shaper.entries.back()[c], cube.min[c], cube.max[c]);
        apart[c] = std::max({apart[c], low, 1 - high});
    }
    const RgbD slope = steepest_edges(*lut.cube);
    // Trilinear and tetrahedral slopes along an axis are means of the edges': never steeper.
    const double bound = apart.r * slope.r + apart.g * slope.g + apart.b * slope.b;
    if (!(bound <= tolerance)) {
        return {};
    }
    lut.cube->domain = folded;
    lut.shaper.reset();
    return {"", "the 1D table is a straight line: the cube's domain says the same", bound};
}

// A cube whose red output depends on red alone, and so on, is three curves. With a 1D table before
// it the two would have to become one table, which is not exact: that is left alone.
Omission cube_to_curve(Lut& lut, double tolerance) {
    if (!lut.cube || lut.shaper) {
        return {};
    }
    const Lut3D& cube = *lut.cube;
    const auto n = static_cast<std::size_t>(cube.size);
    std::vector<Rgb> low(n), high(n);
    for_each_node(cube.size, [&](int r, int g, int b) {
        const std::array<int, 3> at{r, g, b};
        for (std::size_t c = 0; c < 3; ++c) {
            const auto i = static_cast<std::size_t>(at[c]);
            const bool first = at[(c + 1) % 3] == 0 && at[(c + 2) % 3] == 0;
            const float v = cube.at(r, g, b)[c];
            low[i][c] = first ? v : std::min(low[i][c], v);
            high[i][c] = first ? v : std::max(high[i][c], v);
        }
    });
    Lut1D curve{cube.domain, std::vector<Rgb>(n)};
    double bound = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double l = low[i][c], h = high[i][c];
            curve.entries[i][c] = static_cast<float>(l / 2 + h / 2);
            const double middle = curve.entries[i][c];
            bound = std::max({bound, h - middle, middle - l});
        }
    }
    if (!(bound <= tolerance)) {
        return {};
    }
    lut.shaper = std::move(curve);
    lut.cube.reset();
    return {"", "the channels do not mix: a 1D table does what the cube did", bound};
}

// The divisors of `cells`, ascending: how many cells a coarser table on the same places may have.
std::vector<int> coarser(int cells) {
    std::vector<int> out;
    for (int k = 1; k < cells; ++k) {
        if (cells % k == 0) {
            out.push_back(k);
        }
    }
    return out;
}

// Tetrahedra and cells of a lattice on every k-th node consist of whole ones of the fine lattice,
// so both sides are straight, or trilinear, within each fine one.
Omission drop_cube_nodes(Lut& lut, double tolerance) {
    if (!lut.cube) {
        return {};
    }
    const Lut3D& fine = *lut.cube;
    for (const int cells : coarser(fine.size - 1)) {
        const int step = (fine.size - 1) / cells;
        Lut3D coarse{fine.domain, cells + 1, {}};
        for (int b = 0; b < fine.size; b += step) {
            for (int g = 0; g < fine.size; g += step) {
                for (int r = 0; r < fine.size; r += step) {
                    coarse.nodes.push_back(fine.at(r, g, b));
                }
            }
        }
        double bound = 0;
        for (int b = 0; b < fine.size && bound <= tolerance; ++b) {
            for (int g = 0; g < fine.size && bound <= tolerance; ++g) {
                for (int r = 0; r < fine.size; ++r) {
                    const RgbD in = node_position(fine, r, g, b);
                    for (const auto how : {Interpolation::trilinear, Interpolation::tetrahedral}) {
                        bound = std::max(bound, largest_magnitude(evaluate_exact(coarse, in, how) -
                                                                  to_double(fine.at(r, g, b))));
                    }
                }
            }
        }
        if (bound <= tolerance) {
            const std::string words = std::to_string(fine.size) + " nodes per axis become " +
                                      std::to_string(coarse.size) +
                                      ": interpolation gives the others";
            lut.cube = std::move(coarse);
            return {"", words, bound};
        }
    }
    return {};
}

// Of a curve alone; before a cube its error would have to be carried through the cube.
Omission drop_curve_entries(Lut& lut, double tolerance) {
    if (!lut.shaper || lut.cube) {
        return {};
    }
    const Lut1D& fine = *lut.shaper;
    for (const int cells : coarser(fine.size() - 1)) {
        const auto step = static_cast<std::size_t>((fine.size() - 1) / cells);
        Lut1D coarse{fine.domain, {}};
        for (std::size_t i = 0; i < fine.entries.size(); i += step) {
            coarse.entries.push_back(fine.entries[i]);
        }
        double bound = 0;
        for (int i = 0; i < fine.size() && bound <= tolerance; ++i) {
            const RgbD there = evaluate_exact(coarse, entry_position(fine, i));
            bound = std::max(
                bound,
                largest_magnitude(there - to_double(fine.entries[static_cast<std::size_t>(i)])));
        }
        if (bound <= tolerance) {
            const std::string words =
                std::to_string(fine.size()) + " entries of the 1D table become " +
                std::to_string(coarse.size()) + ": interpolation gives the others";
            lut.shaper = std::move(coarse);
            return {"", words, bound};
        }
    }
    return {};
}

constexpr std::array<SimplifyRule, 6> simplify_rows{{
    {"linear-shaper", "a 1D table that is a straight line goes", fold_linear_shaper},
    {"identity-cube", "a cube that changes nothing is not applied", drop_identity_cube},
    {"separable", "a cube whose channels do not mix becomes a 1D table", cube_to_curve},
    {"identity-curve", "a 1D table that changes nothing is not applied", drop_identity_curve},
    {"fewer-nodes", "nodes of the cube that interpolation gives go", drop_cube_nodes},
    {"fewer-entries", "entries of a 1D table that interpolation gives go", drop_curve_entries},
}};

// The nodes, per channel, that inputs within the interval look at: every node of a cell they enter.
std::array<std::vector<bool>, 3> reached_nodes(const Lut& lut, bool unit_inputs) {
    const Lut3D& cube = *lut.cube;
    std::array<std::vector<bool>, 3> out;
    for (std::size_t c = 0; c < 3; ++c) {
        out[c].assign(static_cast<std::size_t>(cube.size), false);
        const double min = cube.domain.min[c],
                     width = static_cast<double>(cube.domain.max[c]) - min;
        const auto mark = [&](double a, double b) {
            const double scale = cube.size - 1;
            const double low = std::clamp((std::min(a, b) - min) / width, 0.0, 1.0) * scale;
            const double high = std::clamp((std::max(a, b) - min) / width, 0.0, 1.0) * scale;
            const auto last = static_cast<std::size_t>(std::ceil(high));
            for (auto i = static_cast<std::size_t>(low); i <= last; ++i) {
                out[c][i] = true;
            }
        };
        if (!lut.shaper) {
            mark(unit_inputs ? 0 : cube.domain.min[c], unit_inputs ? 1 : cube.domain.max[c]);
            continue;
        }
        const Lut1D& shaper = *lut.shaper;
        const double x0 = shaper.domain.min[c], x1 = shaper.domain.max[c];
        const double from = unit_inputs ? std::clamp(0.0, x0, x1) : x0;
        const double to = unit_inputs ? std::clamp(1.0, x0, x1) : x1;
        const auto value = [&](double x) {
            RgbD in;
            in[c] = x;
            return evaluate_exact(shaper, in)[c];
        };
        double last = value(from);
        for (int i = 0; i < shaper.size(); ++i) {
            const double x = entry_position(shaper, i)[c];
            if (x > from && x < to) {
                const double y = value(x);
                mark(last, y);
                last = y;
            }
        }
        mark(last, value(to));
    }
    return out;
}

std::size_t not_reached(const Lut& lut, bool unit_inputs) {
    const auto reached = reached_nodes(lut, unit_inputs);
    std::size_t seen = 1;
    for (const auto& axis : reached) {
        seen *= static_cast<std::size_t>(std::count(axis.begin(), axis.end(), true));
    }
    return lut.cube->nodes.size() - seen;
}

} // namespace

std::span<const SimplifyRule> simplify_rules() {
    return simplify_rows;
}

Simplified simplify(const Lut& lut, const SimplifyOptions& options) {
    Simplified out{lut, {}, 0};
    for (bool again = true; again;) {
        again = false;
        for (const SimplifyRule& rule : simplify_rows) {
            Omission omission = rule.apply(out.lut, options.tolerance - out.bound);
            if (omission.words.empty()) {
                continue;
            }
            omission.name = rule.name;
            out.bound += omission.bound;
            out.omissions.push_back(std::move(omission));
            again = true;
        }
    }
    return out;
}

Unreachable unreachable_nodes(const Lut& lut) {
    if (!lut.cube) {
        return {};
    }
    return {not_reached(lut, false), not_reached(lut, true), lut.cube->nodes.size()};
}

} // namespace lutlib
