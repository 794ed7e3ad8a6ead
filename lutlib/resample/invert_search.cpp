// What the index is asked: the inputs of an output, and the nearest to one that has none.
#include "lutlib/resample/invert_index.h"

#include "lutlib/resample/invert_cells.h"
#include "lutlib/resample/invert_tetrahedron.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lutlib {
namespace {

struct FlatCandidate {
    Cell cell;
    const Walk* path;
    double away; ///< squared, of the cell from the input that it should be near
};

// From a place in shares of the domain to the nearest point of a cell.
double away_from(RgbD goal, Cell cell, double cells) {
    const std::array<int, 3> low{cell.r, cell.g, cell.b};
    RgbD away;
    for (std::size_t c = 0; c < 3; ++c) {
        away[c] = goal[c] - std::clamp(goal[c], low[c] / cells, (low[c] + 1) / cells);
    }
    return square(away);
}

bool may_hold(const std::array<RgbD, 4>& corner, RgbD wanted, double tolerance) {
    for (std::size_t c = 0; c < 3; ++c) {
        const auto [low, high] =
            std::minmax({corner[0][c], corner[1][c], corner[2][c], corner[3][c]});
        if (wanted[c] < low - tolerance || wanted[c] > high + tolerance) {
            return false;
        }
    }
    return true;
}

} // namespace

bool OutputIndex::is_flat(RgbD input) const {
    const Place at = lattice_of(input);
    std::array<int, 3> node{};
    Place fraction{};
    for (std::size_t c = 0; c < 3; ++c) {
        node[c] = std::min(static_cast<int>(at[c]), cube_.size - 2);
        fraction[c] = at[c] - node[c];
    }
    const Walk& path = axes_by_fraction(fraction);
    return lutlib::is_flat(slope(corners(cube_, {node[0], node[1], node[2]}, path), path),
                           rounding_);
}

Preimages OutputIndex::preimages(RgbD wanted, RgbD near) const {
    // Points on a face that two tetrahedra share must be inside at least one of them.
    constexpr double slack = 1e-7;
    Preimages out;
    const double last = cube_.size - 1, tolerance = 1e-6 * std::max(span_, rounding_);
    for (std::size_t c = 0; c < 3; ++c) {
        const double above = wanted[c] - low_[c], x = above * scale_[c];
        const bool is_constant = scale_[c] <= 0;
        if (is_constant ? std::abs(above) > tolerance : x < -slack || x > buckets_ + slack) {
            return out;
        }
    }
    const RgbD goal = share_of(near);
    double best = std::numeric_limits<double>::infinity(); // squared distance of out.flat
    const auto look_at = [&](const Cell& cell, const Walk& path) {
        const auto corner = corners(cube_, cell, path);
        const RgbD first = RgbD{1.0 * cell.r, 1.0 * cell.g, 1.0 * cell.b} * (1 / last);
        std::array<RgbD, 4> input{first, first, first, first};
        for (std::size_t step = 0; step < 3; ++step) {
            input[step + 1] = input[step];
            input[step + 1][path[step]] += 1 / last;
        }
        const TetrahedronPoint found = nearest_in_tetrahedron(input, corner, goal, wanted, span_);
        const double distance = square(found.input - goal);
        if (largest_magnitude(found.output - wanted) <= tolerance && distance < best) {
            best = distance;
            out.flat = place({found.input.r * last, found.input.g * last, found.input.b * last});
        }
    };
    // The goal itself first: where that is it, none can be nearer.
    if (is_flat(near)) {
        const RgbD home = place(lattice_of(near));
        const RgbD there = evaluate_exact(cube_, home, Interpolation::tetrahedral);
        if (largest_magnitude(there - wanted) <= tolerance) {
            best = square(share_of(home) - goal);
            out.flat = home;
        }
    }
    constexpr unsigned all_flat = (1U << tetrahedron_walks.size()) - 1;
    std::vector<FlatCandidate> flat;
    const std::size_t k = bucket_index(bucket_of(wanted));
    const auto n = static_cast<std::uint32_t>(cube_.size);
    for (std::uint32_t i = cell_start_[k]; i < cell_start_[k + 1]; ++i) {
        const std::uint32_t id = cells_[i];
        const unsigned bits = flat_[id];
        if (bits == all_flat && best <= 0) {
            continue;
        }
        const Cell cell{static_cast<int>(id % n), static_cast<int>(id / n % n),
                        static_cast<int>(id / (n * n))};
        const double away = bits ? away_from(goal, cell, last) : 0;
        if (bits == all_flat && away >= best) {
            continue;
        }
        for (std::size_t t = 0; t < tetrahedron_walks.size(); ++t) {
            const Walk& path = tetrahedron_walks[t];
            const bool is_flat = bits >> t & 1;
            if (is_flat && away >= best) {
                continue;
            }
            const auto corner = corners(cube_, cell, path);
            if (!may_hold(corner, wanted, tolerance)) {
                continue;
            }
            if (is_flat) {
                flat.push_back({cell, &path, away});
                continue;
            }
            const RgbD f = inverse(slope(corner, path)) * (wanted - corner[0]);
            if (f[path[0]] <= 1 + slack && f[path[0]] >= f[path[1]] - slack &&
                f[path[1]] >= f[path[2]] - slack && f[path[2]] >= -slack) {
                out.points.push_back(
                    place({cell.r + std::clamp(f.r, 0.0, 1.0), cell.g + std::clamp(f.g, 0.0, 1.0),
                           cell.b + std::clamp(f.b, 0.0, 1.0)}));
            }
        }
    }
    // The nearest first: soon no other can be nearer. Of a wild look so many may hold it and do not
    // that the far ones are left.
    constexpr std::size_t most_tries = 64;
    const auto tried =
        flat.begin() + static_cast<std::ptrdiff_t>(std::min(most_tries, flat.size()));
    std::partial_sort(
        flat.begin(), tried, flat.end(),
        [](const FlatCandidate& a, const FlatCandidate& b) { return a.away < b.away; });
    for (auto candidate = flat.begin(); candidate != tried && candidate->away < best; ++candidate) {
        look_at(candidate->cell, *candidate->path);
    }
    return out;
}

Nearest OutputIndex::descend(RgbD wanted, Place at) const {
    const double last = cube_.size - 1;
    const auto cell_of = [&](const Place& p) {
        const auto axis = [&](double x) { return std::min(static_cast<int>(x), cube_.size - 2); };
        return Cell{axis(p[0]), axis(p[1]), axis(p[2])};
    };
    const auto output = [&](const Place& p, Matrix3* jacobian) {
        const Cell cell = cell_of(p);
        const Place f{p[0] - cell.r, p[1] - cell.g, p[2] - cell.b};
        const Walk& path = axes_by_fraction(f);
        const auto corner = corners(cube_, cell, path);
        const Matrix3 m = slope(corner, path);
        if (jacobian) {
            *jacobian = m;
        }
        return corner[0] + m * RgbD{f[0], f[1], f[2]};
    };
    Matrix3 j;
    RgbD residual = wanted - output(at, &j);
    double damping = 1e-3;
    for (int step = 0; step < 60 && damping < 1e9; ++step) {
        // (J^T J + damping trace I) d = J^T residual, over the axes that are not held at a face.
        Matrix3 t;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                t.m[i][k] = j.m[k][i];
            }
        }
        Matrix3 normal = t * j;
        RgbD gradient = t * residual;
        const double trace = normal.m[0][0] + normal.m[1][1] + normal.m[2][2];
        if (!(trace > 0)) {
            break;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            normal.m[i][i] += damping * trace;
            const bool held = (at[i] <= 0 && gradient[i] < 0) || (at[i] >= last && gradient[i] > 0);
            if (held) {
                for (std::size_t k = 0; k < 3; ++k) {
                    normal.m[i][k] = normal.m[k][i] = i == k ? 1 : 0;
                }
                gradient[i] = 0;
            }
        }
        const RgbD d = inverse(normal) * gradient;
        // Where the look has fewer than three dimensions, little damping leaves no determinant.
        if (!std::isfinite(largest_magnitude(d))) {
            damping *= 4;
            continue;
        }
        Place next{};
        for (std::size_t i = 0; i < 3; ++i) {
            next[i] = std::clamp(at[i] + std::clamp(d[i], -2.0, 2.0), 0.0, last);
        }
        Matrix3 next_j;
        const RgbD next_residual = wanted - output(next, &next_j);
        if (square(next_residual) < square(residual)) {
            const bool done = square(residual) - square(next_residual) < 1e-18 * square(residual);
            at = next;
            residual = next_residual;
            j = next_j;
            damping = std::max(damping / 5, 1e-9);
            if (done) {
                break;
            }
        } else {
            damping *= 4;
        }
    }
    return {place(at), largest_magnitude(residual)};
}

Nearest OutputIndex::nearest(RgbD wanted) const {
    // Rings of buckets round the wanted colour until one holds nodes, and one ring more, because a
    // nearer node may sit just behind a bucket's border.
    const Bucket centre = bucket_of(wanted);
    struct Start {
        double distance;
        std::uint32_t node;
    };
    constexpr std::size_t tries = 4;
    std::array<Start, tries> starts; // the nearest, rising
    std::size_t count = 0;
    const auto keep = [&](Start start) {
        const auto before = [](const Start& a, const Start& b) {
            return a.distance < b.distance || (a.distance == b.distance && a.node < b.node);
        };
        if (count == tries && !before(start, starts.back())) {
            return;
        }
        count = std::min(count + 1, tries);
        std::size_t at = count - 1;
        for (; at > 0 && before(start, starts[at - 1]); --at) {
            starts[at] = starts[at - 1];
        }
        starts[at] = start;
    };
    int rings_left = 2;
    for (int ring = 0; ring < buckets_ && rings_left > 0; ++ring) {
        for (int z = centre[2] - ring; z <= centre[2] + ring; ++z) {
            for (int y = centre[1] - ring; y <= centre[1] + ring; ++y) {
                const bool shell =
                    std::abs(z - centre[2]) == ring || std::abs(y - centre[1]) == ring;
                for (int x = centre[0] - ring; x <= centre[0] + ring;
                     x += shell || ring == 0 ? 1 : 2 * ring) {
                    if (std::min({x, y, z}) < 0 || std::max({x, y, z}) >= buckets_) {
                        continue;
                    }
                    const std::size_t k = bucket_index({x, y, z});
                    for (std::uint32_t i = node_start_[k]; i < node_start_[k + 1]; ++i) {
                        const std::uint32_t id = nodes_[i];
                        keep({square(to_double(cube_.nodes[id]) - wanted), id});
                    }
                }
            }
        }
        rings_left -= count == 0 ? 0 : 1;
    }
    const auto n = static_cast<std::uint32_t>(cube_.size);
    Nearest best;
    best.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t id = starts[i].node;
        const Nearest found =
            descend(wanted, {static_cast<double>(id % n), static_cast<double>(id / n % n),
                             static_cast<double>(id / (n * n))});
        if (found.distance < best.distance) {
            best = found;
        }
    }
    return best;
}

} // namespace lutlib
