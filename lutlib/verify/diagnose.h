// Which well-known mistake makes a LUT picture differ from what it should be.
#pragma once

#include "lutlib/bake/bake.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lutlib {

/// A look that a picture may have been made from by mistake, such as another interpolation.
struct Alternative {
    std::string words;
    Transform look;
};

/// Opened only when a picture is wrong; may be empty.
using Alternatives = std::function<std::vector<Alternative>()>;

/// A mistake in words, and the share of texels that agree with the look once it is assumed; 0 where
/// a mistake leaves no such share, as noise does.
struct Diagnosis {
    std::string words;
    double explained = 0;
};

struct Findings {
    std::optional<Diagnosis> diagnosis; ///< the mistake that explains the picture
    Diagnosis nearest;                  ///< what explains most texels, whether it is enough or not
};

/// Tries every row of a table of mistakes (what would the codes be, had somebody made it?), the
/// pictures of every other engine with these dimensions, and every alternative. Where nearly all
/// texels are right, single ones are damaged. Else the mistake that explains most is the diagnosis
/// if it explains nearly all of them, and nearly all that are wrong without it; else a move of the
/// picture or of its slices that makes nearly all right, and a palette; else differences that
/// vanish at the look's own nodes, where its `breaks` are, are its sampling's, and
/// the noise of a lossy format is recognised by what it does to blocks of texels.
Findings diagnose(const CodeImage& picture, const Engine& engine, int size, const Transform& look,
                  const Breaks& breaks, const Alternatives& alternatives);

/// For each node, red fastest: where it sits in the picture, and the look's value, not clamped, at
/// the input where the engine reads it.
struct RightTexels {
    std::vector<Pixel> pixels;
    std::vector<RgbD> values;
};
RightTexels right_texels(const CodeImage& picture, const Engine& engine, int size,
                         const Transform& look);

/// How far a look's answer may lie from what a right picture was made of, both in 0..1.
double tolerance_of(Precision precision);

/// Whether `code` is `value` (0..1) rounded to nearest, either way when the value lies within the
/// tolerance of a tie.
bool is_rounded(int code, double value, int maximum, double tolerance);

} // namespace lutlib
