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

/// Of a place at most one period away. No remainder: those are slow.
int repeated(int at, int size) {
    return at < 0 ? at + size : at >= size ? at - size : at;
}

/// 0: repeated, 1: mirrored, 2: clamped.
int wrapped(int at, int size, uint mode) {
    if (mode == 2u) {
        return clamp(at, 0, size - 1);
    }
    int place = repeated(at, mode == 1u ? 2 * size : size);
    return place < size ? place : 2 * size - 1 - place;
}

vec4 texel_at(TextureInfo info, int index) {
    bool has_halves = (info.how & 256u) != 0u;
    uint at = info.first + (has_halves ? 2u * uint(index) : uint(index));
    uint word = texels[at];
    return has_halves ? vec4(unpackHalf2x16(word), unpackHalf2x16(texels[at + 1u]))
                      : unpackUnorm4x8(word);
}

vec4 level_at(TextureInfo info, int level, vec2 uv, bool is_smooth) {
    ivec2 size = ivec2(info.sides & 65535u, info.sides >> 16);
    int first = 0;
    for (int i = 0; i < level; ++i) {
        first += size.x * size.y;
        size = max(size / 2, 1);
    }
    vec2 place = uv * vec2(size);
    place = is_smooth ? place - 0.5 : floor(place);
    vec2 low = floor(place);
    vec2 share = place - low; // 0: the nearest texel alone
    ivec2 at = ivec2(low);
    uvec2 mode = uvec2(info.how, info.how >> 2) & 3u;
    ivec2 column = ivec2(wrapped(at.x, size.x, mode.x), wrapped(at.x + 1, size.x, mode.x));
    ivec2 row = first + size.x * ivec2(wrapped(at.y, size.y, mode.y),
                                       wrapped(at.y + 1, size.y, mode.y));
    vec4 upper = mix(texel_at(info, row.x + column.x), texel_at(info, row.x + column.y), share.x);
    vec4 lower = mix(texel_at(info, row.y + column.x), texel_at(info, row.y + column.y), share.x);
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
    bool is_far = level > 0.0;
    bool is_smooth = (info.how & (is_far ? 32u : 16u)) != 0u;
    uint mips = info.how >> 6 & 3u;
    level = is_far && mips != 0u ? min(level, float(info.levels - 1u)) : 0.0;
    if (mips == 1u) {
        level = ceil(level - 0.5);
    }
    int low = int(level);
    float share = level - float(low);
    // Drivers that run on a CPU go through every branch, but leave a loop when no pixel is in it.
    vec4 color = vec4(0.0);
    int count = share > 0.0 ? 2 : 1;
    for (int i = 0; i < count; ++i) {
        color += (i == 0 ? 1.0 - share : share) * level_at(info, low + i, uv, is_smooth);
    }
    return color;
}

#endif
