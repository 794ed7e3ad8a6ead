// Ambient occlusion for every pixel from the cells about it, each of two by two pixels and made for
// its first: those count that lie in the pixel's tangent plane.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#include "common/seen.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform Views { View view; };
layout(binding = 1) uniform sampler2D depths;
layout(binding = 2) uniform usampler2D normals;
layout(binding = 3) uniform sampler2D source;
layout(binding = 4) writeonly uniform image2D target;
layout(push_constant) uniform Push { float radius; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    float depth = texelFetch(depths, at, 0).r;
    ivec2 odd = at & 1, cells = textureSize(source, 0);
    if (depth >= 1.0 || odd == ivec2(0)) {
        imageStore(target, at, vec4(depth >= 1.0 ? 1.0 : texelFetch(source, at / 2, 0).r));
        return;
    }
    vec3 position = ray_at(view, vec2(at) + 0.5, vec2(size)) * z_of(view, depth);
    vec3 normal = decode_octahedral(from_bits(texelFetch(normals, at, 0).xy));
    const float least = 1e-4; // where none lies in the plane, all count
    float sum = 0.0, total = 0.0;
    for (int y = 0; y <= odd.y; ++y) {
        for (int x = 0; x <= odd.x; ++x) {
            ivec2 cell = min(at / 2 + ivec2(x, y), cells - 1);
            float depth_there = texelFetch(depths, 2 * cell, 0).r;
            float weight = least;
            if (depth_there < 1.0) {
                vec3 other =
                    ray_at(view, vec2(2 * cell) + 0.5, vec2(size)) * z_of(view, depth_there);
                float away = abs(dot(normal, other - position));
                weight += max(1.0 - away / (0.1 * radius), 0.0);
            }
            sum += weight * texelFetch(source, cell, 0).r;
            total += weight;
        }
    }
    imageStore(target, at, vec4(sum / total));
}
