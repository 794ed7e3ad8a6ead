// What the index is asked: the inputs of an output, and the nearest to one that has none.
#include "lutlib/resample/invert_index.h"

#include "lutlib/resample/invert_cells.h"
#include "lutlib/resample/invert_tetrahedron.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace lutlib {
namespace {

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

namespace {

// Of the flat tetrahedra that give a colour, the point nearest to a goal, both in shares of the
// cube's domain.
class FlatSearch {
  public:
    FlatSearch(const Lut3D& cube, RgbD wanted, RgbD goal, double tolerance, double span)
        : cube_(cube), wanted_(wanted), goal_(goal), tolerance_(tolerance), span_(span) {}

    void found(RgbD share) {
        const double distance = square(share - goal_);
        if (distance < best_) {
            best_ = distance;
            nearest_ = share;
        }
    }
    /// Whether a cell so far from the goal, squared, may hold a nearer one.
    bool may_improve(double away) const { return away < best_; }
    double away_of(const Cell& cell) const { return away_from(goal_, cell, cube_.size - 1); }
    void add(const Cell& cell, const Walk& path, double away) {
        candidates_.push_back({cell, &path, away});
    }

    /// The nearest first: soon no other can be nearer. Of a wild look so many may hold it and do
    /// not that the far ones are left.
    std::optional<RgbD> settle() {
        constexpr std::size_t most_tries = 64;
        const auto tried = candidates_.begin() +
                           static_cast<std::ptrdiff_t>(std::min(most_tries, candidates_.size()));
        std::partial_sort(candidates_.begin(), tried, candidates_.end(),
                          [](const Candidate& a, const Candidate& b) { return a.away < b.away; });
        for (auto it = candidates_.begin(); it != tried && may_improve(it->away); ++it) {
            look_at(it->cell, *it->path);
        }
        return nearest_;
    }

  private:
    struct Candidate {
        Cell cell;
        const Walk* path;
        double away; ///< squared, of the cell from the goal
    };

    void look_at(const Cell& cell, const Walk& path) {
        const double last = cube_.size - 1;
        const RgbD first = RgbD{1.0 * cell.r, 1.0 * cell.g, 1.0 * cell.b} * (1 / last);
        std::array<RgbD, 4> input{first, first, first, first};
        for (std::size_t step = 0; step < 3; ++step) {
            input[step + 1] = input[step];
            input[step + 1][path[step]] += 1 / last;
        }
        const TetrahedronPoint point =
            nearest_in_tetrahedron(input, corners(cube_, cell, path), goal_, wanted_, span_);
        if (largest_magnitude(point.output - wanted_) <= tolerance_) {
            found(point.input);
        }
    }

    const Lut3D& cube_;
    RgbD wanted_, goal_;
    double tolerance_, span_;
    double best_ = std::numeric_limits<double>::infinity(); // squared
    std::optional<RgbD> nearest_;
    std::vector<Candidate> candidates_;
};

// Points on a face that two tetrahedra share must be inside at least one of them.
constexpr double slack = 1e-7;

// The place within a tetrahedron of the cell that gives the colour, from its lower node.
std::optional<RgbD> fraction_of(const std::array<RgbD, 4>& corner, const Walk& path, RgbD wanted) {
    const RgbD f = inverse(slope(corner, path)) * (wanted - corner[0]);
    if (f[path[0]] <= 1 + slack && f[path[0]] >= f[path[1]] - slack &&
        f[path[1]] >= f[path[2]] - slack && f[path[2]] >= -slack) {
        return saturate(f);
    }
    return std::nullopt;
}

} // namespace

bool OutputIndex::may_give(RgbD wanted, double tolerance) const {
    for (std::size_t c = 0; c < 3; ++c) {
        const double above = wanted[c] - low_[c], x = above * scale_[c];
        const bool is_constant = scale_[c] <= 0;
        if (is_constant ? std::abs(above) > tolerance : x < -slack || x > buckets_ + slack) {
            return false;
        }
    }
    return true;
}

Preimages OutputIndex::preimages(RgbD wanted, RgbD near) const {
    Preimages out;
    const double last = cube_.size - 1, tolerance = 1e-6 * std::max(span_, rounding_);
    if (!may_give(wanted, tolerance)) {
        return out;
    }
    FlatSearch flat(cube_, wanted, share_of(near), tolerance, span_);
    // The goal itself first: where that is it, none can be nearer.
    if (is_flat(near)) {
        const RgbD home = place(lattice_of(near));
        const RgbD there = evaluate_exact(cube_, home, Interpolation::tetrahedral);
        if (largest_magnitude(there - wanted) <= tolerance) {
            flat.found(share_of(home));
        }
    }
    constexpr unsigned all_flat = (1U << tetrahedron_walks.size()) - 1;
    const std::size_t k = bucket_index(bucket_of(wanted));
    const auto n = static_cast<std::uint32_t>(cube_.size);
    for (std::uint32_t i = cell_start_[k]; i < cell_start_[k + 1]; ++i) {
        const std::uint32_t id = cells_[i];
        const auto beyond = [&, &box = outputs_[id]](std::size_t c) {
            return wanted[c] < static_cast<double>(box.low[c]) - tolerance ||
                   wanted[c] > static_cast<double>(box.high[c]) + tolerance;
        };
        if (beyond(0) || beyond(1) || beyond(2)) {
            continue;
        }
        const unsigned bits = flat_[id];
        const Cell cell{static_cast<int>(id % n), static_cast<int>(id / n % n),
                        static_cast<int>(id / (n * n))};
        const double away = bits ? flat.away_of(cell) : 0;
        if (bits == all_flat && !flat.may_improve(away)) {
            continue;
        }
        for (std::size_t t = 0; t < tetrahedron_walks.size(); ++t) {
            const Walk& path = tetrahedron_walks[t];
            const bool is_flat = bits >> t & 1;
            if (is_flat && !flat.may_improve(away)) {
                continue;
            }
            const auto corner = corners(cube_, cell, path);
            if (!may_hold(corner, wanted, tolerance)) {
                continue;
            }
            if (is_flat) {
                flat.add(cell, path, away);
            } else if (const auto f = fraction_of(corner, path, wanted)) {
                out.points.push_back(place({cell.r + f->r, cell.g + f->g, cell.b + f->b}));
            }
        }
    }
    if (const std::optional<RgbD> share = flat.settle()) {
        out.flat = place({share->r * last, share->g * last, share->b * last});
    }
    return out;
}

namespace {

// What a cube makes of a place, and how it changes there.
struct Linear {
    RgbD output;
    Matrix3 slope;
};

Linear linear_at(const Lut3D& cube, const Place& at) {
    const auto axis = [&](double x) { return std::min(static_cast<int>(x), cube.size - 2); };
    const Cell cell{axis(at[0]), axis(at[1]), axis(at[2])};
    const Place f{at[0] - cell.r, at[1] - cell.g, at[2] - cell.b};
    const Walk& path = axes_by_fraction(f);
    const auto corner = corners(cube, cell, path);
    const Matrix3 m = slope(corner, path);
    return {corner[0] + m * RgbD{f[0], f[1], f[2]}, m};
}

// d of (J^T J + damping trace I) d = J^T residual, over the axes that are not held at a face of the
// places 0 .. last; not finite where that has no determinant. Nullopt where nothing changes.
std::optional<RgbD> damped_step(const Matrix3& j, RgbD residual, const Place& at, double last,
                                double damping) {
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
        return std::nullopt;
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
    return inverse(normal) * gradient;
}

} // namespace

Nearest OutputIndex::descend(RgbD wanted, Place at) const {
    const double last = cube_.size - 1;
    Linear here = linear_at(cube_, at);
    RgbD residual = wanted - here.output;
    double damping = 1e-3;
    for (int step = 0; step < 60 && damping < 1e9; ++step) {
        const std::optional<RgbD> d = damped_step(here.slope, residual, at, last, damping);
        if (!d) {
            break;
        }
        // Where the look has fewer than three dimensions, little damping leaves no determinant.
        if (!std::isfinite(largest_magnitude(*d))) {
            damping *= 4;
            continue;
        }
        Place next{};
        for (std::size_t i = 0; i < 3; ++i) {
            next[i] = std::clamp(at[i] + std::clamp((*d)[i], -2.0, 2.0), 0.0, last);
        }
        const Linear there = linear_at(cube_, next);
        const RgbD next_residual = wanted - there.output;
        if (square(next_residual) >= square(residual)) {
            damping *= 4;
            continue;
        }
        const bool done = square(residual) - square(next_residual) < 1e-18 * square(residual);
        at = next;
        residual = next_residual;
        here = there;
        damping = std::max(damping / 5, 1e-9);
        if (done) {
            break;
        }
    }
    return {place(at), largest_magnitude(residual)};
}

namespace {

// The nodes whose outputs lie nearest, of those that were offered.
class NearestNodes {
  public:
    struct Start {
        double distance; ///< squared
        std::uint32_t node;
    };

    void offer(Start start) {
        if (count_ == starts_.size() && !before(start, starts_.back())) {
            return;
        }
        count_ = std::min(count_ + 1, starts_.size());
        std::size_t at = count_ - 1;
        for (; at > 0 && before(start, starts_[at - 1]); --at) {
            starts_[at] = starts_[at - 1];
        }
        starts_[at] = start;
    }
    /// The nearest first.
    std::span<const Start> all() const { return std::span(starts_).first(count_); }

  private:
    static bool before(const Start& a, const Start& b) {
        return a.distance < b.distance || (a.distance == b.distance && a.node < b.node);
    }

    std::array<Start, 4> starts_{};
    std::size_t count_ = 0;
};

} // namespace

Nearest OutputIndex::nearest(RgbD wanted) const {
    // Rings of buckets round the wanted colour until one holds nodes, and one ring more, because a
    // nearer node may sit just behind a bucket's border.
    const Bucket centre = bucket_of(wanted);
    NearestNodes starts;
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
                        starts.offer({square(to_double(cube_.nodes[id]) - wanted), id});
                    }
                }
            }
        }
        rings_left -= starts.all().empty() ? 0 : 1;
    }
    const auto n = static_cast<std::uint32_t>(cube_.size);
    Nearest best;
    best.distance = std::numeric_limits<double>::infinity();
    for (const auto& [distance, id] : starts.all()) {
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
