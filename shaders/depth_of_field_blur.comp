// Gathers what the lens spreads over each cell of texels. Behind the focus a texel counts as
// far as both its own circle and that of the texel it falls on reach: what is sharper in front does
// not bleed, and what is hidden by it does not shine through. Before the focus each texel is spread
// over its own circle, over everything: its share there is opacity.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/disc.glsl"
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int cell_side = 2;
layout(constant_id = 1) const int rings = 3;
layout(binding = 0) uniform sampler2D rest;
layout(binding = 1) uniform sampler2D near;
layout(binding = 2) uniform sampler2D near_radii;
layout(binding = 3) uniform sampler2D tiles;
layout(binding = 4) uniform Disc { vec4 points[most_disc_points]; }; // x, y, distance
layout(binding = 5) writeonly uniform image2D rest_blurred; // and radius; -1: nothing is known
layout(binding = 6) writeonly uniform image2D near_blurred; // and opacity
layout(binding = 7) writeonly uniform image2D reaches;      // of each group
layout(push_constant) uniform Push {
    float largest; // radius, in cells
} push;

#define a_texel (1.0 / float(cell_side)) // in cells
const int disc_points = 1 + 4 * rings * (rings + 1);

shared uint group_reach;

ivec2 last;

ivec2 place_of(ivec2 at, float reach, int i) {
    return clamp(at + ivec2(floor(points[i].xy * reach + 0.5)), ivec2(0), last);
}

/// The sum of covered() over the points of a disc of radius `reach`.
float covered_points(float radius, float reach) {
    float sum = covered(radius, 0.0);
    for (int ring = 1; ring <= rings; ++ring) {
        float apart = float(2 * ring) / float(2 * rings + 1);
        sum += float(8 * ring) * covered(radius, apart * reach);
    }
    return sum;
}

/// The farthest that anything before the focus reaches into the group's texels.
void find_reach() {
    ivec2 own = ivec2(gl_WorkGroupID.xy);
    int tiles_about = int(ceil(push.largest / 16.0));
    int side = 2 * tiles_about + 1;
    for (int i = int(gl_LocalInvocationIndex); i < side * side; i += 256) {
        ivec2 offset = ivec2(i % side, i / side) - tiles_about;
        ivec2 tile = own + offset;
        if (all(greaterThanEqual(tile, ivec2(0))) && all(lessThan(tile, textureSize(tiles, 0)))) {
            float radius = texelFetch(tiles, tile, 0).r;
            float apart = 16.0 * float(max(max(abs(offset.x), abs(offset.y)) - 1, 0));
            if (radius + 0.5 > apart) {
                atomicMax(group_reach, floatBitsToUint(radius));
            }
        }
    }
}

vec4 blurred_rest(ivec2 at, float near_radius, vec4 before) {
    vec4 own = texelFetch(rest, at, 0);
    bool is_hidden = own.a < 0.0;
    if (is_hidden && before.a >= 0.98) {
        return vec4(before.rgb / before.a, 0.0); // hardly anything of it is seen
    }
    if (!is_hidden && own.a < 0.5 * a_texel) {
        return own;
    }
    float reach = is_hidden ? 1.5 * near_radius + 1.0 : own.a;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < disc_points; ++i) {
        vec4 other = texelFetch(rest, place_of(at, reach, i), 0);
        float distance = points[i].z * reach;
        // What is hidden by what lies before the focus is taken from beside it.
        float weight = is_hidden ? 1.0 / (1.0 + distance * distance)
                                 : covered(min(own.a, other.a), distance) /
                                       max(other.a * other.a, a_texel * a_texel);
        weight = other.a < 0.0 ? 0.0 : weight;
        sum += weight * other.rgb;
        weights += weight;
    }
    if (weights > 0.0) {
        return vec4(sum / weights, is_hidden ? 0.0 : own.a);
    }
    return vec4(own.rgb, is_hidden ? -1.0 : own.a);
}

vec4 blurred_near(ivec2 at, float reach) {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < disc_points; ++i) {
        ivec2 there = place_of(at, reach, i);
        float radius = texelFetch(near_radii, there, 0).r;
        float weight = covered(radius, points[i].z * reach);
        if (radius > 0.0 && weight > 0.0) {
            sum += weight / covered_points(radius, reach) * texelFetch(near, there, 0);
        }
    }
    return sum;
}

void main() {
    if (gl_LocalInvocationIndex == 0) {
        group_reach = 0u;
    }
    barrier();
    find_reach();
    barrier();
    float reach = uintBitsToFloat(group_reach);
    if (gl_LocalInvocationIndex == 0) {
        imageStore(reaches, ivec2(gl_WorkGroupID.xy), vec4(reach));
    }
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    last = textureSize(rest, 0) - 1;
    if (any(greaterThan(at, last))) {
        return;
    }
    vec4 before = reach > 0.0 ? blurred_near(at, reach) : vec4(0.0);
    imageStore(near_blurred, at, vec4(round_to_half(min(before.rgb, half_max)), before.a));
    vec4 behind = blurred_rest(at, texelFetch(near_radii, at, 0).r, before);
    imageStore(rest_blurred, at, vec4(round_to_half(min(behind.rgb, half_max)), behind.a));
}
