#include "lutlib/fit/fit.h"

#include "lutlib/fit/acceptance.h"
#include "lutlib/fit/fit_round.h"
#include "lutlib/fit/normal_equations.h"
#include "lutlib/fit/samples.h"

#include <utility>

namespace lutlib {
namespace {

// Codes so fine that plain rounding loses nothing.
constexpr int fine_bits = 16;

std::vector<bool> corners(int size) {
    const auto n = static_cast<std::size_t>(size);
    std::vector<bool> out(n * n * n);
    for (std::size_t corner = 0; corner < 8; ++corner) {
        out[(n - 1) * ((corner & 1) + n * ((corner >> 1 & 1) + n * (corner >> 2)))] = true;
    }
    return out;
}

} // namespace

struct LatticeFit::State {
    int size;
    std::vector<bool> fixed;
    std::vector<RgbD> point;
    FitSamples samples;
    std::vector<RgbD> fitted;
    Acceptance acceptance;
};

LatticeFit::LatticeFit(const Transform& look, const LatticeReader& reader,
                       std::vector<RgbD> point_samples, const FitView& view) {
    std::vector<bool> fixed = corners(reader.size);
    FitSamples samples = fit_samples(look, reader, view.viewing);
    std::vector<RgbD> fitted = least_squares(samples, point_samples, fixed, reader.size);
    state_ = std::make_unique<State>(State{reader.size, std::move(fixed), std::move(point_samples),
                                           std::move(samples), std::move(fitted),
                                           Acceptance(look, reader, view)});
}

LatticeFit::~LatticeFit() = default;
LatticeFit::LatticeFit(LatticeFit&&) noexcept = default;

FittedLattice LatticeFit::exact() const {
    const State& s = *state_;
    return s.acceptance.accepted(s.fitted, s.point,
                                 within_unit(s.samples.target) && s.acceptance.within_unit());
}

FittedLattice LatticeFit::rounded(CodeDepth depth, double tightness) const {
    const State& s = *state_;
    const std::vector<RgbD> plain = rounded_to_codes(s.point, depth);
    std::vector<RgbD> nodes = rounded_to_codes(s.fitted, depth);
    if (depth.bits < fine_bits) {
        nodes = descended(s.samples, std::move(nodes), plain, s.fixed, s.size, depth);
    }
    return s.acceptance.accepted(std::move(nodes), plain, true, tightness);
}

} // namespace lutlib
