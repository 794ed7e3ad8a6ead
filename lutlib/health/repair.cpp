#include "lutlib/health/repair.h"

#include "lutlib/color/luma.h"
#include "lutlib/error.h"
#include "lutlib/health/parts.h"
#include "lutlib/nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lutlib {
namespace {

using Node = std::array<int, 3>;

const Rgb& node_at(const Lut3D& cube, const Node& n) {
    return cube.at(n[0], n[1], n[2]);
}

// `n` moved along an axis; nothing outside the lattice.
std::optional<Node> moved(const Lut3D& cube, Node n, std::size_t axis, int by) {
    n[axis] += by;
    return n[axis] < 0 || n[axis] >= cube.size ? std::nullopt : std::optional<Node>(n);
}

// What the finite neighbours say of a value, and how well they know: 0, the mean of two that
// enclose it; 1, a straight line through two beside it; 2, one neighbour's own value.
struct Guess {
    std::size_t rank;
    float value;
};

std::optional<Guess> from_neighbours(const Lut3D& cube, const Node& n, std::size_t c) {
    std::array<double, 3> sum{};
    std::array<int, 3> count{};
    const auto value = [&](std::size_t axis, int by) -> std::optional<double> {
        const auto m = moved(cube, n, axis, by);
        return m && std::isfinite(node_at(cube, *m)[c])
                   ? std::optional<double>(node_at(cube, *m)[c])
                   : std::nullopt;
    };
    const auto add = [&](std::size_t rank, double v) {
        sum[rank] += v;
        ++count[rank];
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto before = value(axis, -1), after = value(axis, 1);
        if (before && after) {
            add(0, *before / 2 + *after / 2);
        }
        for (const int side : {-1, 1}) {
            const auto near = value(axis, side), far = value(axis, 2 * side);
            if (near && far) {
                add(1, 2 * *near - *far);
            }
            if (near) {
                add(2, *near);
            }
        }
    }
    for (std::size_t rank = 0; rank < 3; ++rank) {
        const auto mean = static_cast<float>(sum[rank] / std::max(count[rank], 1));
        if (count[rank] > 0 && std::isfinite(mean)) {
            return Guess{rank, mean};
        }
    }
    return std::nullopt;
}

// From the edges of each hole inwards; in each round only what is known best.
void fill(Lut3D& cube) {
    struct Missing {
        Node node;
        std::size_t channel;
    };
    std::vector<Missing> missing;
    for_each_node(cube.size, [&](int r, int g, int b) {
        const Node n{r, g, b};
        for (std::size_t c = 0; c < 3; ++c) {
            if (!std::isfinite(node_at(cube, n)[c])) {
                missing.push_back({n, c});
            }
        }
    });
    while (!missing.empty()) {
        std::vector<std::optional<Guess>> guesses;
        std::size_t best = 3;
        for (const Missing& m : missing) {
            guesses.push_back(from_neighbours(cube, m.node, m.channel));
            best = guesses.back() ? std::min(best, guesses.back()->rank) : best;
        }
        if (best == 3) {
            throw Error("a channel of the cube has no value that is a number: nothing to repair "
                        "it from");
        }
        std::vector<Missing> rest;
        for (std::size_t i = 0; i < missing.size(); ++i) {
            const Node& n = missing[i].node;
            if (guesses[i] && guesses[i]->rank == best) {
                cube.at(n[0], n[1], n[2])[missing[i].channel] = guesses[i]->value;
            } else {
                rest.push_back(missing[i]);
            }
        }
        missing = std::move(rest);
    }
}

void fill(Lut1D& curve) {
    auto& e = curve.entries;
    for (std::size_t c = 0; c < 3; ++c) {
        std::optional<std::size_t> last;
        for (std::size_t i = 0; i < e.size(); ++i) {
            if (!std::isfinite(e[i][c])) {
                continue;
            }
            for (std::size_t k = last ? *last + 1 : 0; k < i; ++k) {
                const double t =
                    last ? static_cast<double>(k - *last) / static_cast<double>(i - *last) : 1;
                const double from = last ? e[*last][c] : e[i][c];
                e[k][c] = static_cast<float>(std::lerp(from, static_cast<double>(e[i][c]), t));
            }
            last = i;
        }
        if (!last) {
            throw Error("a channel of the 1D table has no value that is a number: nothing to "
                        "repair it from");
        }
        for (std::size_t k = *last + 1; k < e.size(); ++k) {
            e[k][c] = e[*last][c];
        }
    }
}

bool all_finite(const std::vector<Rgb>& values) {
    return std::all_of(values.begin(), values.end(), health::finite);
}

std::string fill_non_finite(Lut& lut, const RepairOptions&) {
    bool done = false;
    if (lut.shaper && !all_finite(lut.shaper->entries)) {
        fill(*lut.shaper);
        done = true;
    }
    if (lut.cube && !all_finite(lut.cube->nodes)) {
        fill(*lut.cube);
        done = true;
    }
    return done ? "values that were not numbers are filled from their neighbours" : "";
}

// The closest sequence that does not fall, by least squares (pool adjacent violators: Ayer et al.,
// Annals of Mathematical Statistics 26(4), 1955).
std::vector<double> rising(const std::vector<double>& values) {
    struct Pool {
        double sum;
        std::size_t count;
        double mean() const { return sum / static_cast<double>(count); }
    };
    std::vector<Pool> pools;
    for (const double v : values) {
        pools.push_back({v, 1});
        while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
            const Pool top = pools.back();
            pools.pop_back();
            pools.back().sum += top.sum;
            pools.back().count += top.count;
        }
    }
    std::vector<double> out;
    for (const Pool& pool : pools) {
        out.insert(out.end(), pool.count, pool.mean());
    }
    return out;
}

std::string straighten_table(Lut& lut, const RepairOptions&) {
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

// A spike stands out of all lines through it by far more than the lines beside it bend.
constexpr double spike_ratio = 8;
constexpr double least_spike = 0.02; // 5 codes of 8 bits

std::optional<float> without_spike(const Lut3D& cube, const Node& n, std::size_t c) {
    const auto value = [&cube, c](int r, int g, int b) {
        return static_cast<double>(cube.at(r, g, b)[c]);
    };
    const auto [r, g, b] = n;
    const int last = cube.size - 1;
    if (std::min({r, g, b}) == 0 || std::max({r, g, b}) == last) {
        return std::nullopt;
    }
    std::array<double, 3> lines{value(r - 1, g, b) / 2 + value(r + 1, g, b) / 2,
                                value(r, g - 1, b) / 2 + value(r, g + 1, b) / 2,
                                value(r, g, b - 1) / 2 + value(r, g, b + 1) / 2};
    std::sort(lines.begin(), lines.end());
    const double own = value(r, g, b);
    const double out = own > lines[2] ? own - lines[2] : lines[0] - own;
    const double scale = std::max({1.0, std::abs(lines[0]), std::abs(lines[2])});
    if (!(out > least_spike * scale)) {
        return std::nullopt;
    }
    double beside = 0;
    // Diagonally beside too, where a kink across all axes alike shows that `n` is not alone.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (int k = 0; k < 9; ++k) {
            Node centre = n;
            centre[(axis + 1) % 3] += k % 3 - 1;
            centre[(axis + 2) % 3] += k / 3 - 1;
            if (centre == n) {
                continue;
            }
            Node before = centre, after = centre;
            --before[axis];
            ++after[axis];
            const auto at = [&](const Node& m) { return value(m[0], m[1], m[2]); };
            beside = std::max(beside, std::abs(at(before) / 2 - at(centre) + at(after) / 2));
        }
    }
    return out > spike_ratio * beside ? std::optional<float>(static_cast<float>(lines[1]))
                                      : std::nullopt;
}

std::string level_spikes(Lut& lut, const RepairOptions&) {
    if (!lut.cube) {
        return "";
    }
    std::vector<std::pair<std::size_t, Rgb>> found;
    for_each_node(lut.cube->size, [&](int r, int g, int b) {
        const Node n{r, g, b};
        Rgb value = node_at(*lut.cube, n);
        for (std::size_t c = 0; c < 3; ++c) {
            value[c] = without_spike(*lut.cube, n, c).value_or(value[c]);
        }
        if (!(value == node_at(*lut.cube, n))) {
            found.emplace_back(lut.cube->index(n[0], n[1], n[2]), value);
        }
    });
    for (const auto& [index, value] : found) {
        lut.cube->nodes[index] = value;
    }
    return found.empty() ? "" : "single nodes that stood out are levelled with their neighbours";
}

// Chroma, as a share of the cube's width, up to which a neutral's correction is carried outwards.
constexpr double carried = 0.25;

// The same amount is added to all channels, so that no neutral changes its hue; it fades with the
// distance from the neutral axis, so that no step appears beside it.
std::string straighten_neutrals(Lut& lut, const RepairOptions&) {
    if (!lut.cube) {
        return "";
    }
    Lut3D& cube = *lut.cube;
    std::vector<double> values;
    for (int i = 0; i < cube.size; ++i) {
        values.push_back(luma(to_double(cube.at(i, i, i))));
    }
    const double rounding = health::rounding_of(lut);
    double highest = values.front(), fall = 0;
    for (const double v : values) {
        fall = std::max(fall, highest - v);
        highest = std::max(highest, v);
    }
    // A negative is meant to fall.
    if (fall <= rounding || values.back() <= values.front()) {
        return "";
    }
    const std::vector<double> straight = rising(values);
    const double last = cube.size - 1;
    for_each_node(cube.size, [&](int r, int g, int b) {
        const Node n{r, g, b};
        const auto [low, high] = std::minmax({n[0], n[1], n[2]});
        const double chroma = (high - low) / last;
        if (chroma >= carried) {
            return;
        }
        const double level = (n[0] + n[1] + n[2]) / 3.0;
        const auto i = std::min(static_cast<std::size_t>(level), values.size() - 2);
        const double t = level - static_cast<double>(i);
        const double shift = std::lerp(straight[i] - values[i], straight[i + 1] - values[i + 1], t);
        const double u = 1 - chroma / carried;
        const double added = shift * u * u * (3 - 2 * u);
        Rgb& node = cube.at(n[0], n[1], n[2]);
        for (std::size_t c = 0; c < 3; ++c) {
            node[c] = static_cast<float>(static_cast<double>(node[c]) + added);
        }
    });
    return "brighter neutrals no longer become darker";
}

std::string clamp_outputs(Lut& lut, const RepairOptions& options) {
    std::vector<Rgb>* const outputs = !options.clamp ? nullptr
                                      : lut.cube     ? &lut.cube->nodes
                                      : lut.shaper   ? &lut.shaper->entries
                                                     : nullptr;
    bool done = false;
    for (std::size_t i = 0; outputs && i < outputs->size(); ++i) {
        const Rgb held = saturate((*outputs)[i]);
        done = done || !(held == (*outputs)[i]);
        (*outputs)[i] = held;
    }
    return done ? "outputs are clamped to 0..1" : "";
}

constexpr std::array<RepairInfo, 5> table{{
    {"non-finite", "fills values that are not numbers from their neighbours", fill_non_finite},
    {"1d-table", "flattens a 1D table where it is not monotonic", straighten_table},
    {"spikes", "levels single nodes that stand out", level_spikes},
    {"neutral-axis", "stops brighter neutrals from becoming darker", straighten_neutrals},
    {"clamp", "clamps outputs to 0..1, when asked to", clamp_outputs},
}};

// A repair may make room for an earlier one: a levelled spike shows a smaller one beside it, and
// clamped neutrals may fall. Noise, the worst of looks, is done after 40 rounds at most, as each
// moves less by half or so; a look beyond the bound would still be moving by its last bits.
constexpr int most_rounds = 100;

void count_changes(const std::vector<Rgb>& before, const std::vector<Rgb>& after,
                   RepairStep& step) {
    for (std::size_t i = 0; i < before.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = before[i][c], b = after[i][c];
            if (a == b) {
                continue;
            }
            ++step.changed;
            step.largest =
                std::isfinite(a) ? std::max(step.largest, std::abs(a - b)) : step.largest;
        }
    }
}

// One repair, entered into the steps. False where there was nothing to do.
bool make(const RepairInfo& row, const RepairOptions& options, Repaired& out) {
    const Lut before = out.lut;
    const std::string words = row.apply(out.lut, options);
    if (words.empty()) {
        return false;
    }
    auto step = std::find_if(out.steps.begin(), out.steps.end(),
                             [&row](const RepairStep& s) { return s.name == row.name; });
    if (step == out.steps.end()) {
        step = out.steps.insert(step, {row.name, words, 0, 0});
    }
    if (before.shaper) {
        count_changes(before.shaper->entries, out.lut.shaper->entries, *step);
    }
    if (before.cube) {
        count_changes(before.cube->nodes, out.lut.cube->nodes, *step);
    }
    return true;
}

} // namespace

std::span<const RepairInfo> repairs() {
    return table;
}

Repaired repair(const Lut& lut, const RepairOptions& options) {
    Repaired out{lut, {}};
    bool changed = true;
    for (int round = 0; round < most_rounds && changed; ++round) {
        changed = false;
        for (const RepairInfo& row : table) {
            changed = make(row, options, out) || changed;
        }
    }
    return out;
}

} // namespace lutlib
