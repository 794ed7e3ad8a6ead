#include "lutlib/resample/invert_solver.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/resample/invert_curve.h"

#include <algorithm>

namespace lutlib {
namespace {

// Inputs of the cube nearer than this share of its width are one place, found in two tetrahedra
// that share it.
constexpr double same = 1e-5;

Domain range_of(const Lut1D& table) {
    Domain out{table.entries.front(), table.entries.front()};
    for (const Rgb& entry : table.entries) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.min[c] = std::min(out.min[c], entry[c]);
            out.max[c] = std::max(out.max[c], entry[c]);
        }
    }
    return out;
}

} // namespace

InverseSolver::InverseSolver(const Lut& look) : lut_(look), index_(*look.cube) {
    const Domain& domain = look.cube->domain;
    for (std::size_t c = 0; c < 3; ++c) {
        width_ = std::max(width_,
                          static_cast<double>(domain.max[c]) - static_cast<double>(domain.min[c]));
    }
    if (look.shaper) {
        shaped_ = range_of(*look.shaper);
    }
}

InverseAnswer InverseSolver::solve(RgbD wanted) const {
    InverseAnswer out = among(found(wanted, wanted), wanted);
    if (!out.missing) {
        return out;
    }
    const Nearest nearest = index_.nearest(wanted);
    out.input = unshaped(nearest.input);
    const RgbD reachable = evaluate_exact(lut_, out.input);
    out.distance =
        reached(nearest.input) ? nearest.distance : largest_magnitude(reachable - wanted);
    // Rounding may leave a colour on the gamut's surface a hair outside.
    out.missing = out.distance > 1e-6 * std::max(1.0, largest_magnitude(wanted));
    // Of all that give the nearest colour too, the input nearest to the wanted one.
    const InverseAnswer flat = among(found(reachable, wanted), wanted);
    if (flat.moved >= 0) {
        out.input = flat.input;
    }
    return out;
}

Fate InverseSolver::fate(RgbD input) const {
    const RgbD place = shaped(input);
    if (!reached(place) || index_.is_flat(place)) {
        return Fate::flat;
    }
    const RgbD output = evaluate_exact(*lut_.cube, place, Interpolation::tetrahedral);
    const Preimages all = found(output, input);
    const bool elsewhere =
        all.flat || std::any_of(all.points.begin(), all.points.end(), [&](RgbD other) {
            return largest_magnitude(other - place) > same * width_;
        });
    return elsewhere ? Fate::folded : Fate::undoable;
}

double InverseSolver::work() const {
    return std::max(index_.cells_of_bucket(), 1.0);
}

bool InverseSolver::is_flat(RgbD place) const {
    return index_.is_flat(place);
}

bool InverseSolver::reached(RgbD place) const {
    for (std::size_t c = 0; shaped_ && c < 3; ++c) {
        if (place[c] < static_cast<double>(shaped_->min[c]) - same * width_ ||
            place[c] > static_cast<double>(shaped_->max[c]) + same * width_) {
            return false;
        }
    }
    return true;
}

RgbD InverseSolver::unshaped(RgbD place) const {
    for (std::size_t c = 0; lut_.shaper && c < 3; ++c) {
        place[c] = inverse_of_curve(*lut_.shaper, place[c], c);
    }
    return place;
}

RgbD InverseSolver::shaped(RgbD input) const {
    return lut_.shaper ? evaluate_exact(*lut_.shaper, input) : input;
}

Preimages InverseSolver::found(RgbD wanted, RgbD near) const {
    Preimages out = index_.preimages(wanted, shaped(near));
    std::erase_if(out.points, [this](RgbD place) { return !reached(place); });
    if (out.flat && !reached(*out.flat)) {
        out.flat.reset();
    }
    return out;
}

// The input nearest to the wanted colour: the sheet that an unfolded look has.
InverseAnswer InverseSolver::among(const Preimages& all, RgbD wanted) const {
    InverseAnswer out;
    out.missing = all.points.empty() && !all.flat;
    if (out.missing) {
        return out;
    }
    RgbD chosen = all.flat ? *all.flat : all.points.front();
    out.input = unshaped(chosen);
    for (const RgbD& place : all.points) {
        const RgbD input = unshaped(place);
        if (largest_magnitude(input - wanted) < largest_magnitude(out.input - wanted)) {
            chosen = place;
            out.input = input;
        }
    }
    if (all.flat) {
        out.moved = largest_magnitude(out.input - wanted);
        return out;
    }
    for (const RgbD& place : all.points) {
        if (largest_magnitude(place - chosen) > same * width_) {
            out.spread = std::max(out.spread, largest_magnitude(unshaped(place) - out.input));
        }
    }
    return out;
}

} // namespace lutlib
