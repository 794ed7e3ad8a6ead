// What a lookup of preview/look/gpu_lookups.h reads, packed into texels and blocks for the GPU.
#pragma once

#include "lutlib/bake/bake.h"
#include "preview/gpu/types.h"
#include "preview/look/gpu_lookups.h"
#include "preview/look/look_conversion.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace preview {

/// The uniform block `Look` of the shader.
struct LookBlock {
    std::array<float, 4> shaper_min{}, shaper_max{1, 1, 1, 1};
    std::array<float, 4> cube_min{}, cube_max{1, 1, 1, 1};
    std::int32_t size = 0, shaper_size = 0, shaper_row = 1, unused = 0;
};

/// Texels of an image to make.
struct Texels {
    ImageDesc desc;
    std::vector<std::byte> bytes; ///< empty: no such image
};

/// What a lookup reads, ready for the GPU.
struct LookData {
    const GpuLookup* lookup = nullptr;
    LookBlock block;
    Texels picture, volume, shaper;
    /// Of a shared lookup: three half floats and a gap a node, red fastest.
    std::vector<std::uint16_t> nodes;
    /// Unset: behind the tone map, with nothing converted.
    std::optional<LookConversion> conversion;
};

/// No look.
LookData no_look();

/// An engine's picture, for rows of Source::picture. Throws lutlib::Error where the row reads no
/// such picture (the shared ones: 16 nodes, 8 bits).
LookData look_data(const lutlib::CodeImage& codes, int size, const GpuLookup& lookup);

/// A look's own table in float, for rows of Source::table. The texture unit's row keeps 16 bits of
/// values within 0..1, half floats of others; it knows neither shaper nor domain and throws
/// lutlib::Error for a look that has them.
LookData look_data(const lutlib::Lut& look, const GpuLookup& lookup);

} // namespace preview
