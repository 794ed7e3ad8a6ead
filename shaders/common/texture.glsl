// Textures as preview/scene/texture_data.h lays them out. Who includes this defines TEXTURE_BINDING,
// the first of two bindings. preview/reference/texture.h is the same in double.
#ifndef TEXTURE_GLSL
#define TEXTURE_GLSL

struct TextureInfo {
    uint first;
    uint sides;
    uint how;
    uint levels;
};
layout(std430, binding = TEXTURE_BINDING) readonly buffer Textures { TextureInfo textures[]; };
layout(std430, binding = TEXTURE_BINDING + 1) readonly buffer Texels { uint texels[]; };

const uint no_texture = ~0u;

int repeated(int at, int size) {
    return at >= 0 ? at % size : size - 1 - (-1 - at) % size;
}

/// 0: repeated, 1: mirrored, 2: clamped.
int wrapped(int at, int size, uint mode) {
    if (mode == 2u) {
        return clamp(at, 0, size - 1);
    }
    int place = repeated(at, mode == 1u ? 2 * size : size);
    return place < size ? place : 2 * size - 1 - place;
}

vec4 texel_at(TextureInfo info, uint level_first, ivec2 size, ivec2 at) {
    uint index = level_first + uint(wrapped(at.y, size.y, info.how >> 2 & 3u) * size.x +
                                    wrapped(at.x, size.x, info.how & 3u));
    if ((info.how & 256u) == 0u) {
        return unpackUnorm4x8(texels[info.first + index]);
    }
    uint word = info.first + 2u * index;
    return vec4(unpackHalf2x16(texels[word]), unpackHalf2x16(texels[word + 1u]));
}

vec4 level_at(TextureInfo info, int level, vec2 uv, bool is_smooth) {
    ivec2 size = ivec2(info.sides & 65535u, info.sides >> 16);
    uint first = 0u;
    for (int i = 0; i < level; ++i) {
        first += uint(size.x * size.y);
        size = max(size / 2, 1);
    }
    vec2 place = uv * vec2(size);
    if (!is_smooth) {
        return texel_at(info, first, size, ivec2(floor(place)));
    }
    place -= 0.5;
    vec2 low = floor(place);
    vec2 share = place - low;
    ivec2 at = ivec2(low);
    vec4 upper = mix(texel_at(info, first, size, at),
                     texel_at(info, first, size, at + ivec2(1, 0)), share.x);
    vec4 lower = mix(texel_at(info, first, size, at + ivec2(0, 1)),
                     texel_at(info, first, size, at + ivec2(1, 1)), share.x);
    return mix(upper, lower, share.y);
}

/// Into the first periods, where floats still tell texels apart.
float near_zero(float u, uint mode) {
    return mode == 0u ? u - floor(u) : mode == 1u ? u - 2.0 * floor(u / 2.0) : clamp(u, -1.0, 2.0);
}

/// With the filters of Vulkan 1.3, 16.5.7 and 16.8, without anisotropy; `dx` and `dy` are the
/// changes of `uv` to the pixels beside.
vec4 texture_at(uint number, vec2 uv, vec2 dx, vec2 dy) {
    TextureInfo info = textures[number];
    vec2 sides = vec2(info.sides & 65535u, info.sides >> 16);
    dx *= sides;
    dy *= sides;
    float level = 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1e-20));
    uv = vec2(near_zero(uv.x, info.how & 3u), near_zero(uv.y, info.how >> 2 & 3u));
    if (!(level > 0.0)) {
        return level_at(info, 0, uv, (info.how & 16u) != 0u);
    }
    bool is_smooth = (info.how & 32u) != 0u;
    uint mips = info.how >> 6 & 3u;
    level = mips == 0u ? 0.0 : min(level, float(info.levels - 1u));
    if (mips == 1u) {
        level = ceil(level - 0.5);
    }
    int low = int(level);
    vec4 color = level_at(info, low, uv, is_smooth);
    float share = level - float(low);
    return share > 0.0 ? mix(color, level_at(info, low + 1, uv, is_smooth), share) : color;
}

#endif
