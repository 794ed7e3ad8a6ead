#include "preview/reference/texture.h"

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include <algorithm>
#include <cmath>

namespace preview::reference {

namespace {

using Index = long long;

double linear(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Index side_of(std::uint32_t largest, int level) {
    return std::max<Index>(largest >> level, 1);
}

glm::dvec4 code_at(const Picture& picture, bool is_color, Index x, Index y) {
    glm::dvec4 out;
    for (int c = 0; c < 4; ++c) {
        const auto at = static_cast<std::size_t>((y * picture.width + x) * 4 + c);
        const double value = picture.rgba[at] / 255.0;
        out[c] = is_color && c < 3 ? linear(value) : value;
    }
    return out;
}

/// A texel of a level is the mean of what it covers of the level above.
glm::dvec4 texel_at(const Picture& picture, bool is_color, int level, Index x, Index y) {
    if (level == 0) {
        return code_at(picture, is_color, x, y);
    }
    const auto share = [](double low, double high, Index i) {
        return std::max(std::min(high, static_cast<double>(i + 1)) -
                            std::max(low, static_cast<double>(i)),
                        0.0);
    };
    const double width = static_cast<double>(side_of(picture.width, level - 1)) /
                         static_cast<double>(side_of(picture.width, level));
    const double height = static_cast<double>(side_of(picture.height, level - 1)) /
                          static_cast<double>(side_of(picture.height, level));
    glm::dvec4 sum(0);
    for (Index j = 0; j < side_of(picture.height, level - 1); ++j) {
        const double row =
            share(static_cast<double>(y) * height, static_cast<double>(y + 1) * height, j);
        for (Index i = 0; row > 0 && i < side_of(picture.width, level - 1); ++i) {
            const double column =
                share(static_cast<double>(x) * width, static_cast<double>(x + 1) * width, i);
            if (column > 0) {
                sum += row * column * texel_at(picture, is_color, level - 1, i, j);
            }
        }
    }
    return sum / (width * height);
}

Index wrapped(Index at, Index size, Wrap wrap) {
    switch (wrap) {
    case Wrap::clamp:
        return std::clamp<Index>(at, 0, size - 1);
    case Wrap::repeat:
        return (at % size + size) % size;
    case Wrap::mirror:
        break;
    }
    const Index place = (at % (2 * size) + 2 * size) % (2 * size);
    return place < size ? place : 2 * size - 1 - place;
}

glm::dvec4 level_at(const Picture& picture, const Texture& texture, int level, glm::dvec2 uv,
                    bool is_smooth) {
    const Index width = side_of(picture.width, level), height = side_of(picture.height, level);
    const auto at = [&](double x, double y) {
        return texel_at(picture, texture.is_color, level,
                        wrapped(static_cast<Index>(x), width, texture.wrap_u),
                        wrapped(static_cast<Index>(y), height, texture.wrap_v));
    };
    const double x = uv.x * static_cast<double>(width), y = uv.y * static_cast<double>(height);
    if (!is_smooth) {
        return at(std::floor(x), std::floor(y));
    }
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double u = x - 0.5 - left, v = y - 0.5 - top;
    return (1 - v) * ((1 - u) * at(left, top) + u * at(left + 1, top)) +
           v * ((1 - u) * at(left, top + 1) + u * at(left + 1, top + 1));
}

} // namespace

glm::dvec4 texture_at(const Scene& scene, const Texture& texture, glm::dvec2 uv, glm::dvec2 dx,
                      glm::dvec2 dy) {
    const Picture& picture = scene.pictures[texture.picture];
    const glm::dvec2 sides(picture.width, picture.height);
    const double widest = std::max(glm::length(dx * sides), glm::length(dy * sides));
    if (!(widest > 1)) {
        return level_at(picture, texture, 0, uv, texture.is_smooth_near);
    }
    if (texture.mips == Mips::none) {
        return level_at(picture, texture, 0, uv, texture.is_smooth_far);
    }
    const double last = std::floor(std::log2(std::max(picture.width, picture.height)));
    const double level = std::min(std::log2(widest), last);
    if (texture.mips == Mips::nearest) {
        return level_at(picture, texture, static_cast<int>(std::ceil(level - 0.5)), uv,
                        texture.is_smooth_far);
    }
    const double low = std::floor(level), share = level - low;
    const glm::dvec4 color =
        level_at(picture, texture, static_cast<int>(low), uv, texture.is_smooth_far);
    return share > 0
               ? (1 - share) * color + share * level_at(picture, texture, static_cast<int>(low) + 1,
                                                        uv, texture.is_smooth_far)
               : color;
}

glm::dvec4 texture_at(const Scene& scene, const TextureUse& use, glm::dvec2 uv, glm::dvec2 dx,
                      glm::dvec2 dy) {
    if (use.texture == TextureUse::none) {
        return glm::dvec4(1);
    }
    const auto moved = [&](glm::dvec2 p, double one) {
        return glm::dvec2(glm::dot(glm::dvec3(use.u_row), glm::dvec3(p, one)),
                          glm::dot(glm::dvec3(use.v_row), glm::dvec3(p, one)));
    };
    return texture_at(scene, scene.textures[use.texture], moved(uv, 1), moved(dx, 0), moved(dy, 0));
}

} // namespace preview::reference
