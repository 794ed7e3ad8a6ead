#include "preview/scene/texture_data.h"

#include <glm/packing.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace preview {

namespace {

/// A level, linear.
struct Level {
    std::uint32_t width = 0, height = 0;
    std::vector<glm::vec4> texels;
};

std::array<float, 256> linear_codes() {
    std::array<float, 256> out{};
    for (std::size_t code = 0; code < out.size(); ++code) {
        const double v = static_cast<double>(code) / 255;
        out[code] =
            static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    return out;
}

Level level_of(const Picture& picture, bool is_color) {
    static const std::array<float, 256> linear = linear_codes();
    Level out{picture.width, picture.height, {}};
    out.texels.reserve(picture.rgba.size() / 4);
    for (std::size_t at = 0; at + 3 < picture.rgba.size(); at += 4) {
        glm::vec4& texel = out.texels.emplace_back();
        for (int c = 0; c < 4; ++c) {
            const std::uint8_t code = picture.rgba[at + static_cast<std::size_t>(c)];
            texel[c] = is_color && c < 3 ? linear[code] : static_cast<float>(code) / 255;
        }
    }
    return out;
}

/// What texel `at` of a halved side covers of the larger one: texels from `first` on with weights.
struct Cover {
    std::uint32_t first = 0, count = 0;
    std::array<float, 4> weights{};
};

Cover cover_of(std::uint32_t at, std::uint32_t small, std::uint32_t large) {
    const double step = static_cast<double>(large) / small;
    const double low = at * step, high = (at + 1) * step;
    Cover out;
    out.first = static_cast<std::uint32_t>(low);
    for (std::uint32_t i = out.first; i < large && i < high && out.count < 4; ++i) {
        const double share = std::min(high, i + 1.0) - std::max(low, static_cast<double>(i));
        out.weights[out.count++] = static_cast<float>(share / step);
    }
    return out;
}

/// Each texel is the mean of what it covers.
Level halved(const Level& large) {
    Level out{std::max(large.width / 2, 1U), std::max(large.height / 2, 1U), {}};
    std::vector<Cover> columns;
    for (std::uint32_t x = 0; x < out.width; ++x) {
        columns.push_back(cover_of(x, out.width, large.width));
    }
    for (std::uint32_t y = 0; y < out.height; ++y) {
        const Cover rows = cover_of(y, out.height, large.height);
        for (const Cover& column : columns) {
            glm::vec4 sum(0);
            for (std::uint32_t i = 0; i < rows.count; ++i) {
                const std::size_t row = std::size_t{rows.first + i} * large.width;
                for (std::uint32_t j = 0; j < column.count; ++j) {
                    sum +=
                        rows.weights[i] * column.weights[j] * large.texels[row + column.first + j];
                }
            }
            out.texels.push_back(sum);
        }
    }
    return out;
}

std::uint64_t bytes_of(std::uint64_t width, std::uint64_t height, bool is_color) {
    std::uint64_t texels = width * height;
    while (width > 1 || height > 1) {
        width = std::max<std::uint64_t>(width / 2, 1);
        height = std::max<std::uint64_t>(height / 2, 1);
        texels += width * height;
    }
    return texels * (is_color ? 8 : 4);
}

class Layout {
  public:
    Layout(const Scene& scene, std::uint64_t most_bytes) : scene_(scene) {
        for (std::uint64_t bytes = total(); bytes > most_bytes && out_.halvings < 16;
             bytes = total()) {
            ++out_.halvings;
        }
    }

    TextureData run() {
        std::map<std::pair<std::uint32_t, bool>, TextureBlock> known;
        for (const Texture& texture : scene_.textures) {
            const std::pair key{texture.picture, texture.is_color};
            auto found = known.find(key);
            if (found == known.end()) {
                found = known.emplace(key, add(texture)).first;
            }
            TextureBlock block = found->second;
            block.how |= static_cast<std::uint32_t>(texture.wrap_u) |
                         static_cast<std::uint32_t>(texture.wrap_v) << 2U |
                         (texture.is_smooth_near ? 16U : 0U) | (texture.is_smooth_far ? 32U : 0U) |
                         static_cast<std::uint32_t>(texture.mips) << 6U;
            out_.table.push_back(block);
        }
        return std::move(out_);
    }

  private:
    std::uint64_t total() const {
        std::uint64_t bytes = 0;
        for (const Texture& texture : scene_.textures) {
            const Picture& picture = scene_.pictures[texture.picture];
            bytes += bytes_of(std::max(picture.width >> out_.halvings, 1U),
                              std::max(picture.height >> out_.halvings, 1U), texture.is_color);
        }
        return bytes;
    }

    TextureBlock add(const Texture& texture) {
        Level level = level_of(scene_.pictures[texture.picture], texture.is_color);
        for (std::uint32_t i = 0; i < out_.halvings && (level.width > 1 || level.height > 1); ++i) {
            level = halved(level);
        }
        TextureBlock block;
        block.first = static_cast<std::uint32_t>(out_.texels.size());
        block.sides = level.width | level.height << 16U;
        block.how = texture.is_color ? 256 : 0;
        append(level, texture.is_color);
        for (; level.width > 1 || level.height > 1; ++block.levels) {
            level = halved(level);
            append(level, texture.is_color);
        }
        return block;
    }

    void append(const Level& level, bool is_color) {
        for (const glm::vec4& texel : level.texels) {
            if (is_color) {
                out_.texels.push_back(glm::packHalf2x16({texel.x, texel.y}));
                out_.texels.push_back(glm::packHalf2x16({texel.z, texel.w}));
            } else {
                out_.texels.push_back(glm::packUnorm4x8(texel));
            }
        }
    }

    const Scene& scene_;
    TextureData out_;
};

} // namespace

TextureData texture_data(const Scene& scene, std::uint64_t most_bytes) {
    return Layout(scene, most_bytes).run();
}

} // namespace preview
