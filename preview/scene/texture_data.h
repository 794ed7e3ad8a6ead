// Textures in the form that shaders/common/texture.glsl reads: one array of words with every level
// of every picture, and a row a texture. Shaders filter by themselves: both rasterisers then read
// any number of textures of any size by one descriptor, and the same bits on every device. Pictures
// of colours are linear half floats, others bytes.
#pragma once

#include "preview/scene/scene.h"

#include <cstdint>
#include <vector>

namespace preview {

struct TextureBlock {
    std::uint32_t first = 0; ///< word of its largest level
    std::uint32_t sides = 0; ///< width in the lower 16 bits, height in the upper
    std::uint32_t how = 0;   ///< wrap_u: bits 0-1, wrap_v: 2-3, near: 4, far: 5, mips: 6-7, half: 8
    std::uint32_t levels = 1; ///< each half as wide and high, rounded down, 1 at least
};

struct TextureData {
    std::vector<TextureBlock> table;
    std::vector<std::uint32_t> texels;
    std::uint32_t halvings = 0; ///< largest levels left out, so that the rest fits
};

/// `most_bytes`: of the texels; largest levels are left out until they fit.
TextureData texture_data(const Scene& scene, std::uint64_t most_bytes);

} // namespace preview
