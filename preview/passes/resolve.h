// The HDR resolve: the one place where a picture is exposed, made finite and measured.
#pragma once

#include "preview/finish/fit.h"
#include "preview/passes/pass.h"

namespace preview {

/// The pass before "hdr resolve" where a pixel covers so many texels that each of them sums up its
/// rows first.
inline constexpr std::string_view resolve_along_rows = "hdr resolve along rows";

struct [[nodiscard]] Resolved {
    ImageHandle hdr;      ///< in 0..65504, alpha 1
    BufferHandle maximum; ///< buffer of one float: the largest value of any channel; may be empty
};

struct ResolveWork {
    Format format = Format::rgba16f; ///< rgba32f for codes, which a half float does not hold
    bool is_kept = false;            ///< serves further frames of the same light
    bool measures = true;            ///< else there is no maximum
    std::string_view name = "hdr";   ///< of the image, and with "resolve" behind it of the pass
    std::string_view still_right = "scene, lights, camera and exposure are the same";
};

/// `exposure` multiplies. A source of another size than `size` is filtered by area and keeps its
/// proportions: it stands in the middle, between black bars.
Resolved add_resolve(Graph& graph, ImageHandle source, Size size, float exposure,
                     const ResolveWork& work = {});

} // namespace preview
