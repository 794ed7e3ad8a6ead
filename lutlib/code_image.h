// A picture of integer codes, as files and textures hold it.
#pragma once

#include "lutlib/codes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lutlib {

struct Pixel {
    int x = 0, y = 0;
    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// Rows from the top, channels interleaved.
struct CodeImage {
    int width = 0, height = 0;
    int channels = 3; ///< 3 RGB or 4 RGBA (alpha not premultiplied)
    CodeDepth depth;
    std::vector<std::uint16_t> samples;

    std::uint16_t& at(Pixel p, std::size_t channel) { return samples[index(p) + channel]; }
    std::uint16_t at(Pixel p, std::size_t channel) const { return samples[index(p) + channel]; }

  private:
    std::size_t index(Pixel p) const {
        return (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(p.x)) *
               static_cast<std::size_t>(channels);
    }
};

} // namespace lutlib
