// Whether a triangle covers a pixel in it, or is cut out there. Without HAS_CUTOUTS all are solid.
// After vertices, indices, objects, clusters, view and size; defines four bindings from
// CUTOUT_BINDING on.
#ifdef HAS_CUTOUTS
#define DETAIL_BINDING (CUTOUT_BINDING + 1)
#include "common/barycentric.glsl"
#include "common/detail.glsl"
layout(std430, binding = CUTOUT_BINDING) readonly buffer VertexDetails {
    VertexDetail vertex_details[];
};
#include "common/triangle_detail.glsl"

bool is_solid(uint number, ivec2 pixel) {
    Cluster cluster = clusters[number / 64u];
    Object object = objects[cluster.object];
    float least_coverage = material_details[object.material.x].least_coverage;
    if (!(least_coverage > 0.0)) {
        return true;
    }
    uint first = cluster.first_index + number % 64u * 3u;
    vec4 corners[3];
    for (int i = 0; i < 3; ++i) {
        Vertex vertex = vertices[uint(int(indices[first + i]) + cluster.vertex_offset)];
        corners[i] = view.clip * vec4(transform_point(object.model, vertex.position), 1.0);
    }
    vec2 screen = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
    vec3 weights = weights_at(screen, corners[0], corners[1], corners[2]);
    DetailAt point = detail_at(object, cluster, first, corners, screen, vec2(size), weights);
    return base_of(vec3(1.0), object.material.x, point.footprint, point.color).a >= least_coverage;
}
#else
bool is_solid(uint number, ivec2 pixel) {
    return true;
}
#endif
