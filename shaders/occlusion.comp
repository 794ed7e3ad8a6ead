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

/// preview/passes/occlusion.cpp makes them: a direction in the frame of tangent, bitangent and normal,
/// and a share of the radius.
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
    vec3 position = ray_at(view, vec2(at) + 0.5, vec2(size)) * z_of(view, depth);
    vec3 normal = decode_octahedral(from_bits(texelFetch(normals, at, 0).xy));
    vec3 tangent = tangent_to(normal);
    vec3 bitangent = cross(normal, tangent);
    int first = ((cell.y & 3) * 4 + (cell.x & 3)) * samples;
    vec3 right = view.right.xyz / dot(view.right.xyz, view.right.xyz);
    vec3 up = view.up.xyz / dot(view.up.xyz, view.up.xyz);
    float least_rise = 0.01 * radius, most_gap = 2.0 * radius;
    int hidden = 0;
    for (int i = 0; i < samples; ++i) {
        vec4 place = points[first + i];
        vec3 direction = place.x * tangent + place.y * bitangent + place.z * normal;
        vec3 point = position + radius * place.w * direction;
        float z = dot(point, view.forward.xyz);
        if (!(z > view.position_near.w)) {
            continue;
        }
        vec2 screen = vec2(dot(point, right), dot(point, up)) / z;
        ivec2 there = ivec2(floor((screen * 0.5 + 0.5) * vec2(size)));
        if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, size))) {
            continue;
        }
        float depth_there = texelFetch(depths, there, 0).r;
        if (depth_there >= 1.0) {
            continue;
        }
        float shown = z_of(view, depth_there);
        vec3 surface = ray_at(view, vec2(there) + 0.5, vec2(size)) * shown;
        hidden += z > shown && z - shown < most_gap &&
                          dot(normal, surface - position) > least_rise
                      ? 1
                      : 0;
    }
    imageStore(target, cell, vec4(max(1.0 - strength * float(hidden) / float(samples), 0.0)));
}
