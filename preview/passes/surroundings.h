// A sky or a picture of all directions as surfaces take it: a small base, what surfaces of rising
// roughness mirror of it, and its irradiance. Made anew only when the base's source has changed.
#pragma once

#include "preview/graph/graph.h"
#include "preview/passes/pass.h"
#include "preview/scene/surroundings.h"

namespace preview {

struct SurroundingsHandles {
    SurroundingsKind kind = SurroundingsKind::gradient;
    BufferHandle block, harmonics;
    ImageHandle base, levels, mirror, picture, reflectance;
};

/// Roughness k / levels of the pictures k = 1, 2... that surfaces mirror; between them they are
/// interpolated. A base of this size is as fine as the lobe of the first.
constexpr std::uint32_t surroundings_levels = 5;
constexpr Size surroundings_base_size{64, 32};
/// What a mirror sees of a picture; of a sky it sees the sky itself.
constexpr Size surroundings_mirror_size{256, 128};

struct SurroundingsInputs {
    ImageHandle picture;  ///< of a picture's; equirectangular radiance
    float exposure = 0;   ///< of the frame, in stops: the sun's disc stays finite after it
    bool are_kept = true; ///< from frame to frame; else made in each
    Size base = surroundings_base_size;
};

/// Of any kind but the gradient. Noise has a block alone.
SurroundingsHandles add_surroundings(Graph& graph, const Surroundings& surroundings,
                                     const SurroundingsInputs& inputs);

} // namespace preview
