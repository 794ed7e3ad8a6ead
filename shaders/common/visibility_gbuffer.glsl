// Turns the triangle that is nearest at each pixel into what the lighting needs to know of it. With
// HAS_DETAIL that is what textures make of it.
#include "common/scene.glsl"
#include "common/keys.glsl"
#include "common/normal_filter.glsl"
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const bool filters_normals = false;
// Targets that the frame reads, by bits; the depth always is.
layout(constant_id = 1) const uint read_targets = 15u;
const bool writes_normal = (read_targets & 1u) != 0u, writes_material = (read_targets & 2u) != 0u;
const bool writes_albedo = (read_targets & 4u) != 0u, writes_emission = (read_targets & 8u) != 0u;
layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 2) readonly buffer Objects { Object objects[]; };
layout(std430, binding = 3) readonly buffer Clusters { Cluster clusters[]; };
layout(binding = 4) uniform Views { View view; };
layout(std430, binding = 5) readonly buffer Keys { uvec2 keys[]; }; // y: the depth
layout(binding = 6) writeonly uniform uimage2D normals;
layout(binding = 7) writeonly uniform uimage2D material_numbers;
layout(binding = 8) writeonly uniform image2D depths;

#include "common/barycentric.glsl"
#ifdef HAS_DETAIL
#define DETAIL_BINDING 13
#include "common/detail_surface.glsl"
layout(binding = 9) writeonly uniform image2D albedos;
layout(binding = 10) writeonly uniform image2D emissions;
layout(std430, binding = 11) readonly buffer VertexDetails { VertexDetail vertex_details[]; };
layout(std430, binding = 12) readonly buffer Materials { Material materials[]; };
#include "common/triangle_detail.glsl"
#endif

void store(ivec2 at, vec3 normal, uint word, float depth) {
    if (writes_normal) {
        imageStore(normals, at, uvec4(to_bits(encode_octahedral(normal)), 0u, 0u));
    }
    if (writes_material) {
        imageStore(material_numbers, at, uvec4(word));
    }
    imageStore(depths, at, vec4(depth));
}

#ifdef HAS_DETAIL
void store_colors(ivec2 at, vec3 albedo, vec3 emission) {
    if (writes_albedo) {
        imageStore(albedos, at, vec4(round_to_half(albedo), 1.0));
    }
    if (writes_emission) {
        imageStore(emissions, at, vec4(round_to_half(emission), 1.0));
    }
}
#endif

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(depths);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    uvec2 key = keys[key_index(at, size)];
    if (key.y == ~0u) {
        if (writes_normal) {
            imageStore(normals, at, uvec4(0u));
        }
        if (writes_material) {
            imageStore(material_numbers, at, uvec4(0u));
        }
        imageStore(depths, at, vec4(1.0));
#ifdef HAS_DETAIL
        store_colors(at, vec3(0.0), vec3(0.0));
#endif
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
    mat3 normals_of = mat3(normal_of[0], normal_of[1], normal_of[2]);
    vec3 normal = unit_or_up(transform_normal(object, normals_of * weights));
    float added = 0.0;
    if (filters_normals) {
        vec2 step = 2.0 / vec2(size);
        vec3 beside[2];
        for (int i = 0; i < 2; ++i) {
            vec2 place = screen + (i == 0 ? vec2(step.x, 0.0) : vec2(0.0, step.y));
            vec3 shares = shares_of(areas_at(place, corners[0], corners[1], corners[2]));
            beside[i] = unit_or_up(transform_normal(object, normals_of * shares)) - normal;
        }
        added = added_by(beside[0], beside[1]);
    }
#ifdef HAS_DETAIL
    DetailAt point = detail_at(object, cluster, first, corners, screen, vec2(size), weights);
    float coverage;
    Surface s = surface_of(materials[object.material.x], object.material.x, point.footprint,
                           point.color, point.tangent, normal, coverage);
    s.roughness = filtered_roughness(s.roughness, added);
    uint word = pack_surface(s);
    store_colors(at, s.albedo, s.emission);
#else
    uint word = (object.material.x + 1u) | (filters_normals ? pack_added(added) : 0u);
#endif
    store(at, normal, word, uintBitsToFloat(key.y));
}
