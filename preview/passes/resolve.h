// The HDR resolve: the one place where a picture is exposed, made finite and measured.
#pragma once

#include "preview/passes/pass.h"

namespace preview {

struct [[nodiscard]] Resolved {
    ImageHandle hdr;      ///< in 0..65504, alpha 1
    BufferHandle maximum; ///< buffer of one float: the largest value of any channel
};

/// `exposure` multiplies. A source of another size than `size` is filtered by area and keeps its
/// proportions: it stands in the middle, between black bars. `format` is rgba16f, or rgba32f for
/// codes, which a half float does not hold. What is kept serves further frames of the same light.
Resolved add_resolve(Graph& graph, ImageHandle source, Size size, float exposure,
                     Format format = Format::rgba16f, bool is_kept = false);

/// The largest size of the picture's proportions within the box, at least 1x1.
Size fitted(Size picture, Size box);

} // namespace preview
