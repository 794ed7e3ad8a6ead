#include "lutlib/match/match_patches.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/match/greys.h"
#include "lutlib/match/residual_lattice.h"

#include <tbb/parallel_for.h>

namespace lutlib {
namespace {

// A patch counts as a bin of many pixels does; the lattice is stiff, for patches are far apart.
constexpr double patch_weight = 30, patch_smoothness = 100;
constexpr double patch_greys_limit = 2 / 255.0;
// Of the looks that are learnt to be measured.
constexpr int coarse_size = 9;

} // namespace

Match match_patches(std::span<const ColorPair> patches, int size) {
    Match out;
    out.base = fitted_base(patches);
    std::vector<ColorPair> left;
    for (const ColorPair& patch : patches) {
        left.push_back(
            {patch.before, patch.after - out.base(patch.before), patch_weight * patch.weight});
    }
    ResidualLattice residual = residual_lattice(
        left, size, {.smoothness = {patch_smoothness, patch_smoothness, patch_smoothness}});
    out.cube = identity_cube(size);
    for (std::size_t k = 0; k < out.cube.nodes.size(); ++k) {
        Rgb& node = out.cube.nodes[k];
        node = to_float(out.base(to_double(node)) + residual.nodes[k]);
        residual.support[k] /= patch_weight;
    }
    out.support = std::move(residual.support);
    out.greys_fall = make_greys_rise(out.cube, out.support, patch_greys_limit);
    return out;
}

std::vector<RgbD> each_from_the_others(std::span<const ColorPair> patches) {
    std::vector<RgbD> out(patches.size());
    tbb::parallel_for(std::size_t{0}, patches.size(), [&](std::size_t i) {
        std::vector<ColorPair> others(patches.begin(), patches.end());
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        out[i] = evaluate_exact(match_patches(others, coarse_size).cube, patches[i].before,
                                Interpolation::tetrahedral);
    });
    return out;
}

} // namespace lutlib
