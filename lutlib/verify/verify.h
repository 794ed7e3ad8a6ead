// Is this picture the bake of that look for this engine? And if not, what went wrong?
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/verify/diagnose.h"

#include <optional>
#include <vector>

namespace lutlib {

struct TexelCheck {
    std::size_t texels = 0;
    std::size_t wrong = 0;  ///< texels with a channel that is not the rounded code
    int max_difference = 0; ///< in codes, from the code that rounding to nearest gives
    double mean_difference = 0;
    Pixel worst;
};

struct Verification {
    TexelCheck texels;
    Difference lookup;                  ///< measure_lookup()
    std::optional<Diagnosis> diagnosis; ///< when texels are wrong and a mistake explains them
    Diagnosis nearest;                  ///< when they are wrong: what explains most of them
};

/// Compares every texel's code with the look's value at the input where the engine reads the node,
/// rounded to nearest, then the engine's lookup with the look, whose breaks those are. The
/// picture's dimensions must be those of the engine's layout for `size`.
Verification verify(const CodeImage& picture, const Engine& engine, int size, const Transform& look,
                    const Breaks& breaks, const Viewing& viewing, const SampleLimits& limits = {},
                    const Alternatives& alternatives = {});

} // namespace lutlib
