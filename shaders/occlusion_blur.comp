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
    vec3 normal = decode_octahedral(from_bits(texelFetch(normals, at, 0).xy));
    vec2 texel = 2.0 / vec2(size);
    vec3 plane = plane_of(view, normal);
    // A point's height above the origin in the normal's direction, of its z, and what a cell adds.
    float height = dot(plane, vec3((vec2(at) + 0.5) * texel - 1.0, 1.0));
    float step = float(cell_side) * (along_x ? plane.x * texel.x : plane.y * texel.y);
    float own_height = height * z_of(view, depth), per_metre = 1.0 / (0.1 * radius);
    float sum = own, total = 1.0;
    for (int i = -2; i <= 2; ++i) {
        ivec2 other_cell = cell + (along_x ? ivec2(i, 0) : ivec2(0, i));
        if (i == 0 || any(greaterThanEqual(uvec2(other_cell), uvec2(cells)))) {
            continue;
        }
        float depth_there = texelFetch(depths, cell_side * other_cell, 0).r;
        if (depth_there >= 1.0) {
            continue;
        }
        float away = abs((height + float(i) * step) * z_of(view, depth_there) - own_height);
        float weight = (abs(i) == 2 ? 0.5 : 1.0) * max(1.0 - away * per_metre, 0.0);
        sum += weight * texelFetch(source, other_cell, 0).r;
        total += weight;
    }
    imageStore(target, cell, vec4(sum / total));
}
