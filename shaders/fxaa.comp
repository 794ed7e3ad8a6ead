// FXAA after Lottes 2011 ("FXAA 3.11", quality): where the local contrast is high, looks for the
// two ends of the edge and shifts the fetch across it by how near the nearer end is; single texels
// are softened by how far they stand from their neighbours' mean. reference/fxaa.cpp is its twin.
// Every position is a texel centre along the edge, so nothing is left to the texture unit's filter.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/tile.glsl"
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float strength; // 1: all of the shift
} push;

const float least_contrast = 0.0312, relative_contrast = 0.125, softness = 0.75;
const int steps[11] = int[11](1, 1, 1, 1, 1, 2, 2, 2, 2, 4, 8);

ivec2 size;

vec3 color_at(ivec2 at) {
    return texelFetch(source, clamp(at, ivec2(0), size - 1), 0).rgb;
}

float luma_of(vec3 color) {
    return dot(color, vec3(0.299, 0.587, 0.114));
}

float luma_at(ivec2 at) {
    return luma_of(color_at(at));
}

// Follows the border between the rows at and at + across until its mean brightness departs from
// `mean` by `gradient` / 4. Returns how far that is, and whether the end is brighter than `mean`.
void walk(ivec2 at, ivec2 across, ivec2 along, float mean, float gradient, out int reach,
          out float departure) {
    reach = 0;
    for (int i = 0; i < 11; ++i) {
        reach += steps[i];
        ivec2 there = at + reach * along;
        departure = 0.5 * (luma_at(there) + luma_at(there + across)) - mean;
        if (abs(departure) >= 0.25 * gradient) {
            return;
        }
    }
}

vec3 antialiased(ivec2 at) {
    vec3 own = color_at(at);
    float m = luma_of(own);
    float n = luma_at(at + ivec2(0, -1)), s = luma_at(at + ivec2(0, 1));
    float w = luma_at(at + ivec2(-1, 0)), e = luma_at(at + ivec2(1, 0));
    float brightest = max(m, max(max(n, s), max(w, e)));
    float darkest = min(m, min(min(n, s), min(w, e)));
    float contrast = brightest - darkest;
    if (!(contrast >= max(least_contrast, relative_contrast * brightest))) {
        return own;
    }
    float nw = luma_at(at + ivec2(-1, -1)), ne = luma_at(at + ivec2(1, -1));
    float sw = luma_at(at + ivec2(-1, 1)), se = luma_at(at + ivec2(1, 1));

    float mean = (2.0 * (n + s + w + e) + nw + ne + sw + se) / 12.0;
    float apart = clamp(abs(mean - m) / contrast, 0.0, 1.0);
    apart = apart * apart * (3.0 - 2.0 * apart);
    float soft = apart * apart * softness;

    float horizontal = abs(nw - 2.0 * w + sw) + 2.0 * abs(n - 2.0 * m + s) + abs(ne - 2.0 * e + se);
    float vertical = abs(nw - 2.0 * n + ne) + 2.0 * abs(w - 2.0 * m + e) + abs(sw - 2.0 * s + se);
    bool is_horizontal = horizontal >= vertical;
    ivec2 along = is_horizontal ? ivec2(1, 0) : ivec2(0, 1);
    ivec2 across = is_horizontal ? ivec2(0, 1) : ivec2(1, 0);
    float before = is_horizontal ? n : w, after = is_horizontal ? s : e;
    bool steeper_before = abs(before - m) >= abs(after - m);
    float other = steeper_before ? before : after;
    across = steeper_before ? -across : across;
    float gradient = abs(other - m), edge = 0.5 * (other + m);

    int back, forth;
    float departure_back, departure_forth;
    walk(at, across, -along, edge, gradient, back, departure_back);
    walk(at, across, along, edge, gradient, forth, departure_forth);
    float nearer = float(min(back, forth));
    float departure = back < forth ? departure_back : departure_forth;
    // The edge bends towards this texel only if the nearer end is not on this texel's side of it.
    float shift = (m < edge) != (departure < 0.0) ? 0.5 - nearer / float(back + forth) : 0.0;
    shift = max(shift, soft);
    return mix(own, color_at(at + across), push.strength * shift);
}

void main() {
    size = textureSize(source, 0);
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = tile_texel(i);
        if (all(lessThan(at, size))) {
            imageStore(target, at, vec4(antialiased(at), 1.0));
        }
    }
}
