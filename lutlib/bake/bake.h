// From a look to the codes of an engine's LUT picture, and what that costs.
#pragma once

#include "lutlib/code_image.h"
#include "lutlib/engine/engine.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/transform.h"

#include <cstdint>
#include <vector>

namespace lutlib {

/// What rounding and clamping took, over all nodes.
struct BakeLoss {
    std::size_t clamped_values = 0; ///< channel values outside 0..1
    double most_clamped = 0;        ///< the furthest such value's distance from 0..1
    double max_rounding = 0;        ///< largest distance from a value in 0..1 to its code
    double mean_rounding = 0;
};

struct Bake {
    const Engine* engine = nullptr;
    int size = 0;
    CodeImage picture; ///< RGB
    BakeLoss loss;
};

/// Samples the look, of display-encoded colours, at the inputs where the engine reads its nodes,
/// clamps to 0..1 (NaN to 0), rounds to nearest, and lays the codes out. Throws UsageError when the
/// engine takes no such size or depth.
Bake bake(const Transform& look, const Engine& engine, int size, int bits);

/// Lays out nodes that are there already (red fastest), as bake() does with its samples.
Bake lay_out(const std::vector<RgbD>& nodes, const Engine& engine, int size, int bits);

/// The codes as the engine's sampler sees them: code / maximum.
Picture decoded(const CodeImage& codes);

/// What the engine's lookup makes of a colour.
Transform read_by(const Engine& engine, Picture picture, int size);

/// A look as a picture's codes can hold it: to 0..1.
Transform held_to_codes(const Transform& look);

/// measure() of the engine's lookup of codes against the look held to 0..1, over all codes that the
/// engine may feed. `breaks` are those of the look.
Difference measure_lookup(const CodeImage& codes, const Engine& engine, int size,
                          const Transform& look, const Breaks& breaks, const Viewing& viewing,
                          const SampleLimits& limits = {});

/// Throws UsageError unless the engine takes a lattice of `size` with `bits` a sample.
void check_contract(const Engine& engine, int size, int bits);

} // namespace lutlib
