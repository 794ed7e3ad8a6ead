// One invocation a triangle: places it in the picture, clips it, and rasterises it if it is small.
// A large one is listed for visibility_tiles.comp.
#include "common/scene.glsl"
#include "common/raster.glsl"
#include "common/keys.glsl"
layout(local_size_x = 64) in;
layout(constant_id = 0) const int small_side = 16; // pixels; larger ones are left to workgroups
layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 2) readonly buffer Objects { Object objects[]; };
layout(std430, binding = 3) readonly buffer Clusters { Cluster clusters[]; };
layout(binding = 4) uniform Views { View view; };
layout(std430, binding = 5) buffer Keys { uint64_t keys[]; };
layout(std430, binding = 6) coherent buffer Counts { uint64_t counts[]; };
layout(std430, binding = 7) writeonly buffer LargeTriangles { LargeTriangle large_triangles[]; };
layout(push_constant) uniform Push {
    ivec2 size;
    uint cluster_count;
    uint capacity; // of the list of large triangles
};

#define CUTOUT_BINDING 8
#include "common/cutout.glsl"

/// How far the fixed-point grid reaches, in clip space over w: 32767 pixels from the picture's
/// corner to either side.
vec2 guard_band() {
    return 65534.0 / vec2(size) - 1.0;
}

ivec2 on_grid(vec4 clip) {
    precise vec2 pixels = (clip.xy / clip.w * 0.5 + 0.5) * vec2(size);
    precise vec2 steps = floor(pixels * float(subpixels) + 0.5);
    return ivec2(steps);
}

void draw_pixels(Triangle t, ivec2 low, ivec2 high) {
    Walk walk = walk_at(t, low);
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
            ivec2 offset = ivec2(x, y) - low;
            if (covers(walk, offset) && is_solid(t.number, ivec2(x, y))) {
                atomicMin(keys[key_index(ivec2(x, y), size)], key_at(walk, offset, t.number));
            }
        }
    }
}

/// Lists the triangle; false when the list is full.
bool list_large(Triangle t, PixelBox box) {
    if (uint(counts[0] >> tile_bits) >= capacity) {
        return false;
    }
    ivec2 tiles = tiles_of(box);
    uint64_t before =
        atomicAdd(counts[0], (uint64_t(1) << tile_bits) + uint64_t(tiles.x * tiles.y));
    uint index = uint(before >> tile_bits);
    if (index >= capacity) {
        return false;
    }
    large_triangles[index].triangle = t;
    large_triangles[index].first_tile = before & ((uint64_t(1) << tile_bits) - 1);
    return true;
}

/// Front faces wind counter-clockwise in the picture, which has y down: a negative cross product.
void draw(vec4 p, vec4 q, vec4 r, uint number) {
    if (!(min(p.w, min(q.w, r.w)) > 0.0)) {
        return;
    }
    Triangle t = Triangle(on_grid(p), on_grid(r), on_grid(q), p.z / p.w, r.z / r.w, q.z / q.w,
                          number);
    if (cross_64(t.b - t.a, t.c - t.a) <= 0) {
        return;
    }
    PixelBox box = box_of(t, size);
    ivec2 sides = box.high - box.low + 1;
    if (any(lessThanEqual(sides, ivec2(0)))) {
        return;
    }
    if (any(greaterThan(sides, ivec2(small_side))) && list_large(t, box)) {
        return;
    }
    for (int y = box.low.y; y <= box.high.y; y += tile_side) {
        for (int x = box.low.x; x <= box.high.x; x += tile_side) {
            draw_pixels(t, ivec2(x, y), min(ivec2(x, y) + tile_side - 1, box.high));
        }
    }
}

const int plane_count = 5;

/// Not negative on the side that stays: the near plane, then the guard band's four.
float beyond(int plane, vec4 p, vec2 guard) {
    switch (plane) {
    case 0:
        return p.z;
    case 1:
        return guard.x * p.w - p.x;
    case 2:
        return guard.x * p.w + p.x;
    case 3:
        return guard.y * p.w - p.y;
    default:
        return guard.y * p.w + p.y;
    }
}

/// Where the edge meets the plane, always from the inside out: both triangles of an edge get the
/// same bits.
vec4 meeting(vec4 inside, vec4 outside, float d_inside, float d_outside, int plane) {
    precise float share = d_inside / (d_inside - d_outside);
    precise vec4 p = inside + (outside - inside) * share;
    if (plane == 0) {
        p.z = 0.0;
    }
    return p;
}

/// Sutherland and Hodgman 1974.
void draw_clipped(vec4 p, vec4 q, vec4 r, uint number) {
    vec4 polygon[3 + plane_count];
    polygon[0] = p;
    polygon[1] = q;
    polygon[2] = r;
    int count = 3;
    vec2 guard = guard_band();
    for (int plane = 0; plane < plane_count; ++plane) {
        vec4 clipped[3 + plane_count];
        int kept = 0;
        for (int i = 0; i < count; ++i) {
            vec4 from = polygon[i], to = polygon[i + 1 < count ? i + 1 : 0];
            float d_from = beyond(plane, from, guard), d_to = beyond(plane, to, guard);
            if (d_from >= 0.0) {
                clipped[kept++] = from;
            }
            if (d_from >= 0.0 && d_to < 0.0) {
                clipped[kept++] = meeting(from, to, d_from, d_to, plane);
            } else if (d_from < 0.0 && d_to >= 0.0) {
                clipped[kept++] = meeting(to, from, d_to, d_from, plane);
            }
        }
        count = kept;
        for (int i = 0; i < count; ++i) {
            polygon[i] = clipped[i];
        }
    }
    for (int i = 2; i < count; ++i) {
        draw(polygon[0], polygon[i - 1], polygon[i], number);
    }
}

/// Bits for the planes that the point lies outside of: the frustum's sides and near plane in the
/// lower five, the guard band in the sixth.
uint outside_of(vec4 p, vec2 guard) {
    return (p.z < 0.0 ? 1u : 0u) | (p.x > p.w ? 2u : 0u) | (p.x < -p.w ? 4u : 0u) |
           (p.y > p.w ? 8u : 0u) | (p.y < -p.w ? 16u : 0u) |
           (any(greaterThan(abs(p.xy), guard * p.w)) ? 32u : 0u);
}

vec4 place(Object object, uint vertex) {
    return view.clip * vec4(transform_point(object.model, vertices[vertex].position), 1.0);
}

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    if (group >= cluster_count) {
        return;
    }
    Cluster cluster = clusters[group];
    uint local = gl_LocalInvocationID.x;
    if (local >= cluster.triangle_count) {
        return;
    }
    uint first = cluster.first_index + local * 3u;
    Object object = objects[cluster.object];
    vec4 corners[3];
    uint outside[3];
    vec2 guard = guard_band();
    for (int i = 0; i < 3; ++i) {
        corners[i] = place(object, uint(int(indices[first + i]) + cluster.vertex_offset));
        if (any(isnan(corners[i])) || any(isinf(corners[i]))) {
            return;
        }
        outside[i] = outside_of(corners[i], guard);
    }
    if ((outside[0] & outside[1] & outside[2] & 31u) != 0u) {
        return;
    }
    uint number = group * 64u + local;
#ifdef HAS_CUTOUTS
    // One call, for what it draws through is large and compiled into each.
    const bool may_pass = false;
#else
    const bool may_pass = true;
#endif
    if (may_pass && ((outside[0] | outside[1] | outside[2]) & 33u) == 0u) {
        draw(corners[0], corners[1], corners[2], number);
    } else {
        draw_clipped(corners[0], corners[1], corners[2], number);
    }
}
