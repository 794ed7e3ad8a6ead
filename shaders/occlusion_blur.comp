// Averages the ambient occlusion over the four cells in which its offsets repeat, along one axis,
// and over the same surface only.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#include "common/seen.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int cell_side = 2;
layout(constant_id = 1) const bool along_x = true;
layout(binding = 0) uniform Views { View view; };
layout(binding = 1) uniform sampler2D depths;
layout(binding = 2) uniform usampler2D normals;
layout(binding = 3) uniform sampler2D source;
layout(binding = 4) writeonly uniform image2D target;
layout(push_constant) uniform Push { float radius; };

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    ivec2 cells = imageSize(target), size = textureSize(depths, 0);
    if (any(greaterThanEqual(cell, cells))) {
        return;
    }
    ivec2 at = cell_side * cell;
    float own = texelFetch(source, cell, 0).r;
    float depth = texelFetch(depths, at, 0).r;
    if (depth >= 1.0) {
        imageStore(target, cell, vec4(own));
        return;
    }
    vec3 position = ray_at(view, vec2(at) + 0.5, vec2(size)) * z_of(view, depth);
    vec3 normal = decode_octahedral(from_bits(texelFetch(normals, at, 0).xy));
    float per_metre = 1.0 / (0.1 * radius);
    float sum = own, total = 1.0;
    for (int i = -2; i <= 2; ++i) {
        ivec2 other_cell = cell + (along_x ? ivec2(i, 0) : ivec2(0, i));
        if (i == 0 || any(lessThan(other_cell, ivec2(0))) ||
            any(greaterThanEqual(other_cell, cells))) {
            continue;
        }
        ivec2 there = cell_side * other_cell;
        float depth_there = texelFetch(depths, there, 0).r;
        if (depth_there >= 1.0) {
            continue;
        }
        vec3 other = ray_at(view, vec2(there) + 0.5, vec2(size)) * z_of(view, depth_there);
        float away = abs(dot(normal, other - position));
        float weight = (abs(i) == 2 ? 0.5 : 1.0) * max(1.0 - away * per_metre, 0.0);
        sum += weight * texelFetch(source, other_cell, 0).r;
        total += weight;
    }
    imageStore(target, cell, vec4(sum / total));
}
