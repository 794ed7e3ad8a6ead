// Ambient occlusion before its blur (preview/passes/occlusion.h); preview/reference/occlusion.h is
// the same in double.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#include "common/seen.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int cell_side = 2;
layout(constant_id = 1) const int samples = 16;
layout(binding = 0) uniform Views { View view; };
layout(binding = 1) uniform sampler2D depths;
layout(binding = 2) uniform usampler2D normals;
layout(binding = 3) writeonly uniform image2D target;
layout(push_constant) uniform Push { float radius, strength; };

/// preview/passes/occlusion.cpp makes them: in the frame of tangent, bitangent and normal, of a hemisphere
/// of radius 1.
layout(std430, binding = 4) readonly buffer Points { vec4 points[]; };

/// Across the normal, away from its smallest component. Of components that are equal, as those of
/// floors and walls are but for rounding, the first.
vec3 tangent_to(vec3 n) {
    const float same = 1e-3;
    vec3 a = abs(n);
    vec3 axis = a.x <= a.y + same && a.x <= a.z + same ? vec3(1.0, 0.0, 0.0)
                : a.y <= a.z + same                    ? vec3(0.0, 1.0, 0.0)
                                                       : vec3(0.0, 0.0, 1.0);
    return normalize(cross(n, axis));
}

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = textureSize(depths, 0);
    if (any(greaterThanEqual(cell, imageSize(target)))) {
        return;
    }
    ivec2 at = cell_side * cell;
    float depth = texelFetch(depths, at, 0).r;
    if (depth >= 1.0) {
        imageStore(target, cell, vec4(1.0));
        return;
    }
    vec2 texel = 2.0 / vec2(size), first_texel = 0.5 * texel - 1.0; // of the picture from -1 to 1
    float near = view.position_near.w, z = z_of(view, depth);
    vec3 position = vec3(vec2(at) * texel + first_texel, 1.0) * z;
    vec3 normal = decode_octahedral(from_bits(texelFetch(normals, at, 0).xy));
    vec3 tangent = tangent_to(normal);
    mat3 to_seen = seen_from(view);
    mat3 hemisphere = radius * to_seen * mat3(tangent, cross(normal, tangent), normal);
    vec3 plane = plane_of(view, normal);
    float own_rise = dot(plane, position) + 0.01 * radius, most_gap = 2.0 * radius;
    int first = ((cell.y & 3) * 4 + (cell.x & 3)) * samples;
    uvec2 last = uvec2(size) - 1u;
    vec2 half_size = 0.5 * vec2(size);
    int hidden = 0;
    // Without a branch, so that many texels are on their way at once.
    for (int i = 0; i < samples; ++i) {
        vec3 point = position + hemisphere * points[first + i].xyz;
        vec2 place = point.xy / max(point.z, near) * half_size + half_size;
        uvec2 there = uvec2(ivec2(floor(place)));
        bool is_seen = point.z > near && all(lessThan(there, uvec2(size)));
        // Of what is infinitely far: it lies behind every point.
        float shown = z_of(view, texelFetch(depths, ivec2(min(there, last)), 0).r);
        float rise = dot(plane, vec3(vec2(there) * texel + first_texel, 1.0)) * shown;
        bool is_behind = point.z > shown && point.z - shown < most_gap && rise > own_rise;
        hidden += is_seen && is_behind ? 1 : 0;
    }
    imageStore(target, cell, vec4(max(1.0 - strength * float(hidden) / float(samples), 0.0)));
}
