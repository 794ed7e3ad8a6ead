// The one place where a picture becomes finite: exposure, sanitising, and the largest value. A
// picture of another size is filtered by the area that a pixel covers, between black bars.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/tile.glsl"
layout(constant_id = 0) const bool resized = false;
layout(constant_id = 1) const bool is_half = true; // the target
layout(constant_id = 2) const bool measures = true;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(std430, binding = 2) buffer Maximum { uint maximum; };
layout(push_constant) uniform Push {
    ivec2 corner, extent; // of the picture in the target, where it is resized
    float exposure;
};

shared uint group_maximum;

vec3 light_at(ivec2 at) {
    return sanitise(texelFetch(source, at, 0).rgb * exposure);
}

/// The mean over the pixel's area in the source, which is at least one texel wide.
vec3 filtered(ivec2 at) {
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, extent))) {
        return vec3(0.0);
    }
    ivec2 source_size = textureSize(source, 0);
    // Borders that fall between texels do so exactly: a share of 1e-5 of a bright texel would shine.
    vec2 low_edge = vec2(at * source_size) / vec2(extent);
    vec2 high_edge = vec2((at + 1) * source_size) / vec2(extent);
    vec2 centre = vec2((2 * at + 1) * source_size) / vec2(2 * extent);
    vec2 low_corner = min(low_edge, centre - 0.5), high_corner = max(high_edge, centre + 0.5);
    ivec2 first = ivec2(floor(low_corner));
    ivec2 last = ivec2(ceil(high_corner)) - 1;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int y = first.y; y <= last.y; ++y) {
        // Row by row, or what is added vanishes beside what is there.
        vec3 row_sum = vec3(0.0);
        float row_weights = 0.0;
        for (int x = first.x; x <= last.x; ++x) {
            vec2 low = max(vec2(x, y), low_corner);
            vec2 high = min(vec2(x, y) + 1.0, high_corner);
            float weight = max(high.x - low.x, 0.0) * max(high.y - low.y, 0.0);
            row_sum += weight * light_at(clamp(ivec2(x, y), ivec2(0), source_size - 1));
            row_weights += weight;
        }
        sum += row_sum;
        weights += row_weights;
    }
    return sum / max(weights, 1e-20);
}

void main() {
    if (gl_LocalInvocationIndex == 0) {
        group_maximum = 0u;
    }
    barrier();
    ivec2 size = imageSize(target);
    vec3 light[texels_each];
    float brightest = 0.0;
    for (int i = 0; i < texels_each; ++i) {
        ivec2 at = min(tile_texel(i), size - 1);
        light[i] = resized ? filtered(at - corner) : light_at(at);
        light[i] = is_half ? round_to_half(light[i]) : light[i];
        brightest = max(brightest, max(light[i].r, max(light[i].g, light[i].b)));
    }
    for (int i = 0; i < texels_each; ++i) {
        if (all(lessThan(tile_texel(i), size))) {
            imageStore(target, tile_texel(i), vec4(light[i], 1.0));
        }
    }
    if (!measures) {
        return;
    }
    // Non-negative floats order like their bits.
    atomicMax(group_maximum, floatBitsToUint(brightest));
    barrier();
    if (gl_LocalInvocationIndex == 0) {
        atomicMax(maximum, group_maximum);
    }
}
