// Turns the triangle that is nearest at each pixel into what the lighting needs to know of it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#include "common/keys.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 2) readonly buffer Objects { Object objects[]; };
layout(std430, binding = 3) readonly buffer Clusters { Cluster clusters[]; };
layout(binding = 4) uniform Views { View view; };
layout(std430, binding = 5) readonly buffer Keys { uvec2 keys[]; }; // y: the depth
layout(binding = 6) writeonly uniform uimage2D normals;
layout(binding = 7) writeonly uniform uimage2D material_numbers;
layout(binding = 8) writeonly uniform image2D depths;

float cross_2d(vec2 a, vec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// Perspective-correct weights of the corners at a point of the screen: the areas of its triangles
/// with two corners each, all in clip space relative to the point, where they keep their digits
/// also for triangles smaller than a pixel. Centres just outside by the rounding of vertices are
/// moved in.
vec3 weights_at(vec2 screen, vec4 a, vec4 b, vec4 c) {
    vec2 to_a = a.xy - screen * a.w, to_b = b.xy - screen * b.w, to_c = c.xy - screen * c.w;
    vec3 areas = vec3(cross_2d(to_b, to_c), cross_2d(to_c, to_a), cross_2d(to_a, to_b));
    vec3 weights = max(areas * sign(areas.x + areas.y + areas.z), 0.0);
    float sum = weights.x + weights.y + weights.z;
    return sum > 0.0 ? weights / sum : vec3(1.0 / 3.0);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(depths);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    uvec2 key = keys[key_index(at, size)];
    if (key.y == ~0u) {
        imageStore(normals, at, uvec4(0u));
        imageStore(material_numbers, at, uvec4(0u));
        imageStore(depths, at, vec4(1.0));
        return;
    }
    uint number = ~key.x;
    Cluster cluster = clusters[number / 64u];
    uint first = cluster.first_index + number % 64u * 3u;
    Object object = objects[cluster.object];
    vec4 corners[3];
    vec3 normal_of[3];
    for (int i = 0; i < 3; ++i) {
        Vertex vertex = vertices[uint(int(indices[first + i]) + cluster.vertex_offset)];
        corners[i] = view.clip * vec4(transform_point(object.model, vertex.position), 1.0);
        normal_of[i] = decode_octahedral(unpackSnorm2x16(vertex.normal));
    }
    vec2 screen = (vec2(at) + 0.5) / vec2(size) * 2.0 - 1.0;
    vec3 weights = weights_at(screen, corners[0], corners[1], corners[2]);
    vec3 normal = transform_normal(
        object, mat3(normal_of[0], normal_of[1], normal_of[2]) * weights);
    imageStore(normals, at, uvec4(to_bits(encode_octahedral(unit_or_up(normal))), 0u, 0u));
    imageStore(material_numbers, at, uvec4(object.material.x + 1u));
    imageStore(depths, at, vec4(uintBitsToFloat(key.y)));
}
