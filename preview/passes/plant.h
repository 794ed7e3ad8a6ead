// A fault on purpose: a copy of an image with one texel of another value, for `lutpreview check`
// and tests. No picture that anybody sees has it.
#pragma once

#include "preview/passes/pass.h"

namespace preview {

/// One texel of an image and what all its colour channels become there.
struct Planted {
    std::uint32_t x = 0, y = 0;
    float value = 0;
};

/// Whether images of this shape can hold every float, and be copied: plain ones of floats.
bool can_be_planted(const ImageDesc& desc);

/// A copy in the same format, of depth in r32f. Alpha stays.
ImageHandle add_plant(Graph& graph, ImageHandle image, const Planted& planted);

} // namespace preview
