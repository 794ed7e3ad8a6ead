#include "preview/scene/pictures.h"

#include "preview/scene/angles.h"
#include "preview/scene/picture_maker.h"

#include <glm/common.hpp>

#include <cmath>

namespace preview {

namespace {

/// In 0..1. PCG by Jarzynski and Olano 2020, "Hash functions for GPU rendering".
float hashed(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t state = (x * 1664525U + y) * 747796405U + seed * 2891336453U + 1U;
    state = ((state >> ((state >> 28U) + 4U)) ^ state) * 277803737U;
    state = (state >> 22U) ^ state;
    return static_cast<float>(state >> 8U) / 16777215.0F;
}

std::uint32_t wrapped(int cell, int period) {
    const int rest = cell % period;
    return static_cast<std::uint32_t>(rest < 0 ? rest + period : rest);
}

constexpr float board_count = 4;

struct Wood {
    float grain; ///< 0: early wood, 1: late
    float tone;  ///< of the board
    float joint; ///< 1 in the joint between boards
};

Wood wood_at(glm::vec2 at) {
    const float y = board_count * at.y;
    const float board = std::floor(y);
    const auto seed = static_cast<std::uint32_t>(board);
    const float across = y - board;
    const glm::vec2 own(at.x + hashed(seed, 7, 1), at.y + 0.37F * hashed(seed, 3, 2));
    const float bend = layered_noise({3 * own.x, 6 * own.y}, {3, 6}, 3, 11 + seed);
    const float rings = 0.5F + 0.5F * std::sin(2 * pi * (34 * own.y + 3.2F * bend));
    const float fibres = layered_noise({6 * own.x, 160 * own.y}, {6, 160}, 2, 31 + seed);
    const float end = std::abs(std::remainder(at.x - hashed(seed, 5, 3), 1.0F));
    const float edge = std::min(across, 1 - across) / board_count;
    Wood out{};
    out.grain = std::clamp(0.42F * rings * rings + 0.6F * (fibres - 0.25F), 0.0F, 1.0F);
    out.tone = hashed(seed, 1, 4);
    out.joint = 1 - glm::smoothstep(0.0008F, 0.003F, std::min(edge, end));
    return out;
}

/// Height of a plain weave, 0..1: the thread on top lies over the other in every second crossing.
float weave_height(glm::vec2 at) {
    const glm::vec2 p = at * static_cast<float>(weave_threads);
    const glm::vec2 cell = glm::floor(p);
    const glm::vec2 inside = p - cell - 0.5F;
    const bool is_warp = std::fmod(std::abs(cell.x + cell.y), 2.0F) < 0.5F;
    const float across = is_warp ? inside.x : inside.y;
    const float along = is_warp ? inside.y : inside.x;
    return std::cos(pi * across) * (0.55F + 0.45F * std::cos(pi * along));
}

} // namespace

float value_noise(glm::vec2 at, glm::ivec2 period, std::uint32_t seed) {
    const float x = std::floor(at.x);
    const float y = std::floor(at.y);
    const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
    const float u = smooth(at.x - x);
    const float v = smooth(at.y - y);
    const std::uint32_t x0 = wrapped(static_cast<int>(x), period.x);
    const std::uint32_t x1 = wrapped(static_cast<int>(x) + 1, period.x);
    const std::uint32_t y0 = wrapped(static_cast<int>(y), period.y);
    const std::uint32_t y1 = wrapped(static_cast<int>(y) + 1, period.y);
    return std::lerp(std::lerp(hashed(x0, y0, seed), hashed(x1, y0, seed), u),
                     std::lerp(hashed(x0, y1, seed), hashed(x1, y1, seed), u), v);
}

float layered_noise(glm::vec2 at, glm::ivec2 period, int octaves, std::uint32_t seed) {
    float sum = 0;
    float whole = 0;
    float share = 1;
    for (int i = 0; i < octaves; ++i) {
        sum += share * value_noise(at, period, seed + static_cast<std::uint32_t>(i));
        whole += share;
        at *= 2;
        period *= 2;
        share /= 2;
    }
    return sum / whole;
}

Picture zone_plate(std::uint32_t side, float n) {
    return color_picture("zone plate", side, [n](glm::vec2 at) {
        const glm::vec2 p = 2.0F * at - 1.0F;
        const float phase = pi * n * (p.x * p.x + p.y * p.y) / 2;
        return glm::vec3(0.5F + 0.5F * std::cos(phase));
    });
}

const Picture& boards() {
    static const Picture made = color_picture("boards", 512, [](glm::vec2 at) {
        const Wood wood = wood_at(at);
        const glm::vec3 early(0.42F, 0.235F, 0.115F);
        const glm::vec3 late(0.17F, 0.072F, 0.03F);
        return glm::mix(early, late, wood.grain) * (0.65F + 0.55F * wood.tone) *
               (1 - 0.88F * wood.joint);
    });
    return made;
}

const Picture& board_surface() {
    static const Picture made = number_picture("board surface", 256, [](glm::vec2 at) {
        const Wood wood = wood_at(at);
        return glm::vec3(1, 0.75F + 0.25F * std::max(wood.joint, 1 - wood.grain), 0);
    });
    return made;
}

const Picture& weave_shades() {
    static const Picture made = color_picture("weave", 256, [](glm::vec2 at) {
        const float slub = layered_noise(at * 8.0F, glm::ivec2(8), 3, 71);
        return glm::vec3((0.55F + 0.45F * weave_height(at)) * (0.88F + 0.12F * slub));
    });
    return made;
}

const Picture& weave_normals() {
    constexpr float depth = 0.35F / weave_threads;
    static const Picture made =
        normal_picture("weave normals", 256, [](glm::vec2 at) { return depth * weave_height(at); });
    return made;
}

const Picture& brushed_normals() {
    static const Picture made = normal_picture("brushed normals", 256, [](glm::vec2 at) {
        return 0.0012F * layered_noise({3 * at.x, 96 * at.y}, {3, 96}, 2, 51);
    });
    return made;
}

const Picture& dented_normals() {
    static const Picture made = normal_picture("dented normals", 256, [](glm::vec2 at) {
        return 0.006F * layered_noise(at * 28.0F, glm::ivec2(28), 2, 61);
    });
    return made;
}

const Picture& garden() {
    static const Picture made = color_picture("garden", 64, [](glm::vec2 at) {
        const float leaves = layered_noise(at * 6.0F, glm::ivec2(64), 3, 101);
        const float hedge = glm::smoothstep(0.5F, 0.72F, at.y + 0.35F * (leaves - 0.5F));
        const glm::vec3 sky = glm::mix(glm::vec3(0.62F, 0.8F, 1), glm::vec3(1), at.y);
        return glm::mix(sky, glm::vec3(0.08F, 0.13F, 0.05F) * (0.5F + leaves), hedge);
    });
    return made;
}

const Picture& plaster() {
    static const Picture made = color_picture("plaster", 256, [](glm::vec2 at) {
        const float clouds = layered_noise(at * 4.0F, glm::ivec2(4), 5, 81);
        return glm::vec3(0.8F + 0.2F * clouds);
    });
    return made;
}

} // namespace preview
