#include "preview/cli/bench_pictures.h"

#include "lutlib/codes.h"

#include <algorithm>
#include <cmath>

namespace preview {

lutlib::Lut sample_look(int size) {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(size);
    for (lutlib::Rgb& node : look.cube->nodes) {
        const float luma = 0.2126F * node.r + 0.7152F * node.g + 0.0722F * node.b;
        for (std::size_t c = 0; c < 3; ++c) {
            const float v = std::clamp(luma + 1.3F * (node[c] - luma), 0.0F, 1.0F);
            node[c] = v * v * (3 - 2 * v);
        }
    }
    return look;
}

std::vector<float> picture_texels(Size size, float brightest) {
    std::vector<float> texels;
    texels.reserve(std::size_t{4} * size.width * size.height);
    std::uint32_t state = 1;
    for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(size.width);
            const float v = static_cast<float>(y) / static_cast<float>(size.height);
            state = state * 1664525U + 1013904223U;
            const float noise = static_cast<float>(state >> 8) / 16777216.0F * 0.02F;
            const bool block = (x / 160 + y / 120) % 3 == 0;
            const bool lamp = x % 640 < 12 && y % 540 < 12;
            const float base = lamp ? brightest : 1.0F;
            texels.insert(texels.end(),
                          {base * (block ? 0.9F - u * 0.6F : u) + noise,
                           base * (block ? v : 0.2F + 0.6F * v) + noise,
                           base * (0.5F + 0.4F * std::sin(7 * u + 3 * v)) + noise, 1.0F});
        }
    }
    return texels;
}

std::vector<std::uint8_t> codes_of(const std::vector<float>& texels) {
    std::vector<std::uint8_t> codes;
    codes.reserve(texels.size());
    for (const float v : texels) {
        codes.push_back(static_cast<std::uint8_t>(lutlib::CodeDepth{8}.code(v)));
    }
    return codes;
}

std::vector<float> picture_depths(Size size) {
    constexpr std::uint32_t across = 8; // columns of discs
    const float field = static_cast<float>(size.width) / static_cast<float>(across);
    std::vector<float> out;
    out.reserve(std::size_t{size.width} * size.height);
    for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const float u = static_cast<float>(x) / field, v = static_cast<float>(y) / field;
            const float dx = u - std::floor(u) - 0.5F, dy = v - std::floor(v) - 0.5F;
            const bool is_disc = dx * dx + dy * dy < 0.24F;
            const float place = std::fmod(3 * std::floor(u) + 5 * std::floor(v), 8.0F) / 8;
            const float z = 0.5F * std::exp2(4 * place);
            out.push_back(is_disc ? 1 - depths_near_plane / z : 1);
        }
    }
    return out;
}

} // namespace preview
