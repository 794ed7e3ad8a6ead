// Ambient occlusion for every pixel from the cells about it, each of cell_side by cell_side pixels and
// made for its first: those count that lie in the pixel's tangent plane, by how near they are. A
// thread makes a cell's pixels, which share what it reads.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#include "common/seen.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int cell_side = 2;
layout(binding = 0) uniform Views { View view; };
layout(binding = 1) uniform sampler2D depths;
layout(binding = 2) uniform usampler2D normals;
layout(binding = 3) uniform sampler2D source;
layout(binding = 4) writeonly uniform image2D target;
layout(push_constant) uniform Push { float radius; };

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target), cells = textureSize(source, 0);
    if (any(greaterThanEqual(cell, cells))) {
        return;
    }
    // This cell, and those to the right of it, below it and across.
    float depth_of[4], occlusion_of[4];
    vec3 position_of[4];
    for (int i = 0; i < 4; ++i) {
        ivec2 there = min(cell + ivec2(i & 1, i >> 1), cells - 1);
        depth_of[i] = texelFetch(depths, cell_side * there, 0).r;
        occlusion_of[i] = texelFetch(source, there, 0).r;
        position_of[i] =
            ray_at(view, vec2(cell_side * there) + 0.5, vec2(size)) * z_of(view, depth_of[i]);
    }
    imageStore(target, cell_side * cell, vec4(depth_of[0] >= 1.0 ? 1.0 : occlusion_of[0]));
    for (int pixel = 1; pixel < cell_side * cell_side; ++pixel) {
        ivec2 within = ivec2(pixel % cell_side, pixel / cell_side);
        vec2 way = vec2(within) / float(cell_side);
        ivec2 at = cell_side * cell + within;
        if (any(greaterThanEqual(at, size))) {
            continue;
        }
        float depth = texelFetch(depths, at, 0).r;
        if (depth >= 1.0) {
            imageStore(target, at, vec4(1.0));
            continue;
        }
        vec3 position = ray_at(view, vec2(at) + 0.5, vec2(size)) * z_of(view, depth);
        vec3 normal = decode_octahedral(from_bits(texelFetch(normals, at, 0).xy));
        const float least = 1e-4; // where none lies in the plane, all count
        float sum = 0.0, total = 0.0;
        for (int i = 0; i < 4; ++i) {
            vec2 near = mix(1.0 - way, way, vec2(i & 1, i >> 1));
            float share = near.x * near.y;
            if (share == 0.0) {
                continue; // no neighbour of the pixel
            }
            float weight = least;
            if (depth_of[i] < 1.0) {
                float away = abs(dot(normal, position_of[i] - position));
                weight += max(1.0 - away / (0.1 * radius), 0.0);
            }
            sum += share * weight * occlusion_of[i];
            total += share * weight;
        }
        imageStore(target, at, vec4(sum / total));
    }
}
