// The size of a picture. Plain: no Vulkan header.
#pragma once

#include <cstdint>

namespace preview {

struct Size {
    std::uint32_t width = 0, height = 0;
    friend bool operator==(const Size&, const Size&) = default;
};

/// Half of a size, rounded up: the next level of a pyramid.
constexpr Size half(Size size) {
    return {(size.width + 1) / 2, (size.height + 1) / 2};
}

} // namespace preview
