// Pictures on surfaces, as plain data in glTF 2.0's terms.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace preview {

/// Rows from the top, four bytes a texel.
struct Picture {
    std::string name; ///< for people
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

enum class Wrap : std::uint8_t { repeat, mirror, clamp };
enum class Mips : std::uint8_t { none, nearest, linear };

/// How a picture is read.
struct Texture {
    std::uint32_t picture = 0;
    bool is_color = false; ///< red, green and blue are sRGB-encoded; else all are numbers
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    bool is_smooth_near = true; ///< bilinear where a texel is larger than a pixel
    bool is_smooth_far = true;  ///< and where it is smaller
    Mips mips = Mips::linear;
};

/// One of a material's textures and the place on it: (u, v, 1) times the rows.
struct TextureUse {
    static constexpr std::uint32_t none = UINT32_MAX;
    std::uint32_t texture = none;
    std::uint32_t uv_set = 0; ///< 0 or 1
    glm::vec3 u_row{1, 0, 0}, v_row{0, 1, 0};
    friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

/// What a material has besides its numbers, which its textures multiply.
struct MaterialDetail {
    TextureUse base{};      ///< albedo and coverage
    TextureUse surface{};   ///< green: roughness, blue: metalness
    TextureUse normal{};    ///< in the frame of tangents, n / 2 + 1/2
    TextureUse occlusion{}; ///< red: share of the surroundings' light that arrives
    TextureUse emission{};
    float normal_scale = 1, occlusion_strength = 1;
    float coverage = 1;       ///< 0..1
    float least_coverage = 0; ///< what is covered less is cut out; 0: nothing is
    bool is_blended = false;  ///< lets through what it does not cover
    bool is_unlit = false;    ///< shows its albedo whatever the light
    friend bool operator==(const MaterialDetail&, const MaterialDetail&) = default;
};

} // namespace preview
