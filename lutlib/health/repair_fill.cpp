// Values that are no numbers, filled from those beside them.
#include "lutlib/error.h"
#include "lutlib/health/parts.h"
#include "lutlib/health/repair_parts.h"
#include "lutlib/nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lutlib::health {
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
    return std::all_of(values.begin(), values.end(), finite);
}

} // namespace

std::string fill_non_finite(Lut& lut, const RepairOptions& /*options*/) {
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

} // namespace lutlib::health
