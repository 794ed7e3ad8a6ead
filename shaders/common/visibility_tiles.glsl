// Rasterises the large triangles: a workgroup takes one tile of one triangle after the other, 8x8
// pixels at a time.
#ifdef HAS_CUTOUTS
#include "common/scene.glsl"
#endif
#include "common/raster.glsl"
#include "common/keys.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Counts { uint64_t counts[]; };
layout(std430, binding = 1) readonly buffer LargeTriangles { LargeTriangle large_triangles[]; };
layout(std430, binding = 2) buffer Keys { uint64_t keys[]; };
layout(push_constant) uniform Push {
    ivec2 size;
    uint capacity;
};

#ifdef HAS_CUTOUTS
layout(std430, binding = 3) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 4) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 5) readonly buffer Objects { Object objects[]; };
layout(std430, binding = 6) readonly buffer Clusters { Cluster clusters[]; };
layout(binding = 7) uniform Views { View view; };
#endif
#define CUTOUT_BINDING 8
#include "common/cutout.glsl"

/// The triangle that the tile belongs to: the last that starts at or before it.
uint owner_of(uint64_t tile, uint count) {
    uint low = 0u, high = count;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (large_triangles[middle].first_tile <= tile) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

void draw_tile(Triangle t, ivec2 origin) {
    Walk walk = walk_at(t, origin);
    if (!may_cover(walk, ivec2(0), tile_side)) {
        return;
    }
    for (int y = 0; y < tile_side; y += 8) {
        for (int x = 0; x < tile_side; x += 8) {
            if (!may_cover(walk, ivec2(x, y), 8)) {
                continue;
            }
            ivec2 offset = ivec2(x, y) + ivec2(gl_LocalInvocationID.xy);
            ivec2 pixel = origin + offset;
            if (covers(walk, offset) && all(lessThan(pixel, size)) &&
                is_solid(t.number, pixel)) {
                atomicMin(keys[key_index(pixel, size)], key_at(walk, offset, t.number));
            }
        }
    }
}

void main() {
    uint count = min(uint(counts[0] >> tile_bits), capacity);
    if (count == 0u) {
        return;
    }
    LargeTriangle last = large_triangles[count - 1u];
    ivec2 last_tiles = tiles_of(box_of(last.triangle, size));
    uint64_t total = last.first_tile + uint64_t(last_tiles.x * last_tiles.y);
    for (uint64_t tile = gl_WorkGroupID.x; tile < total; tile += gl_NumWorkGroups.x) {
        LargeTriangle large = large_triangles[owner_of(tile, count)];
        PixelBox box = box_of(large.triangle, size);
        int within = int(tile - large.first_tile), columns = tiles_of(box).x;
        ivec2 place = box.low / tile_side + ivec2(within % columns, within / columns);
        draw_tile(large.triangle, place * tile_side);
    }
}
