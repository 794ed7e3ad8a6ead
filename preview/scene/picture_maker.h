// A picture from a function of the place on it.
#pragma once

#include "preview/scene/texture.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace preview {

/// Rows of a square picture; `texel(at)` gives what is stored as 0..1 for a texel's middle.
template <class Texel>
Picture number_picture(std::string name, std::uint32_t side, Texel texel) {
    Picture out{std::move(name), side, side, {}};
    out.rgba.reserve(std::size_t{4} * side * side);
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const glm::vec3 value = texel((glm::vec2(x, y) + 0.5F) / static_cast<float>(side));
            for (int c = 0; c < 3; ++c) {
                out.rgba.push_back(
                    static_cast<std::uint8_t>(std::lround(255 * std::clamp(value[c], 0.0F, 1.0F))));
            }
            out.rgba.push_back(255);
        }
    }
    return out;
}

/// The same of linear light, which is stored as sRGB codes (IEC 61966-2-1).
template <class Light>
Picture color_picture(std::string name, std::uint32_t side, Light light) {
    return number_picture(std::move(name), side, [&](glm::vec2 at) {
        glm::vec3 value = light(at);
        for (int c = 0; c < 3; ++c) {
            value[c] = value[c] <= 0.0031308F ? 12.92F * value[c]
                                              : 1.055F * std::pow(value[c], 1 / 2.4F) - 0.055F;
        }
        return value;
    });
}

/// Normals of a height (in sides of the picture) as glTF's normal textures have them.
template <class Height>
Picture normal_picture(std::string name, std::uint32_t side, Height height) {
    const float step = 1 / static_cast<float>(side);
    return number_picture(std::move(name), side, [&](glm::vec2 at) {
        const float dx = (height(at + glm::vec2(step, 0)) - height(at - glm::vec2(step, 0)));
        const float dy = (height(at + glm::vec2(0, step)) - height(at - glm::vec2(0, step)));
        // Rows run down, the second coordinate of a normal up.
        const glm::vec3 n(-dx / (2 * step), dy / (2 * step), 1);
        const float length = std::sqrt(n.x * n.x + n.y * n.y + 1);
        return n / length * 0.5F + 0.5F;
    });
}

} // namespace preview
