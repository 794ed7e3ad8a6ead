// Sampling a transform into tables, in parallel: what baking, resampling and composing share.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/lut.h"
#include "lutlib/transform.h"

#include <string_view>

namespace lutlib {

/// The transform at every node of a lattice over `domain`. Throws Error for a size or a domain
/// outside limits.h.
Lut3D sample_cube(const Transform& transform, const Domain& domain, int size);

/// A cube over 0..1 to stand behind `shaper`, whose entries rise strictly from 0 to 1: the
/// transform at the inputs that the shaper maps to the nodes.
Lut3D sample_cube_behind(const Transform& transform, const Lut1D& shaper, int size);

/// The curve of the encoding named `shaper` over light, `domain` being codes of `input`, scaled to
/// 0..1. Throws Error when there is no such encoding or it does not rise strictly over the domain.
Lut1D encoding_shaper(std::string_view shaper, const Encoding& input, const Domain& domain,
                      int size);

} // namespace lutlib
