// Rasterising triangles in compute: fixed-point edge functions, and a buffer of the nearest
// triangle at every pixel.
//
// Vertices stand on a grid of 256 steps a pixel within +-32768 pixels (guard_band). An edge from a
// to b has E(p) = cross(b - a, p - a), an exact 64-bit integer that is positive inside; a pixel
// whose centre lies on the edge counts only where the edge is a top or left one, so that triangles
// with a common edge neither overlap nor leave a hole (Pineda 1988, "A parallel algorithm for
// polygon rasterization"). Pixels are 256 apart, so floor(E / 256) has the sign of E at all of them
// and steps by b - a: within 32 pixels 32 bits hold it, and what lies further than that is held at
// 2^30, beyond the reach of the steps.
//
// A pixel's key is the depth's bits over the triangle's number, both such that the least wins: the
// nearest, and of equals the last. Keys lie in blocks of 8x8 pixels.
#ifndef RASTER_GLSL
#define RASTER_GLSL

const int subpixels = 256;
const int tile_side = 32; // pixels

struct Triangle {
    ivec2 a, b, c; // in sub-pixels, such that cross(b - a, c - a) > 0
    float depth_a, depth_b, depth_c;
    uint number;
};

/// A triangle that is left to whole workgroups, tile by tile.
struct LargeTriangle {
    Triangle triangle;
    uint64_t first_tile; // how many tiles those before it have
};

/// Large triangles in the upper 24 bits, all their tiles in the lower 40.
const int tile_bits = 40;

int64_t cross_64(ivec2 u, ivec2 v) {
    return int64_t(u.x) * int64_t(v.y) - int64_t(u.y) * int64_t(v.x);
}

/// The pixels whose centres lie within the triangle's box and the picture; empty where low exceeds
/// high in either direction.
struct PixelBox {
    ivec2 low, high;
};

PixelBox box_of(Triangle t, ivec2 size) {
    const int half_pixel = subpixels / 2;
    PixelBox box;
    box.low = max((min(t.a, min(t.b, t.c)) + (half_pixel - 1)) >> 8, ivec2(0));
    box.high = min((max(t.a, max(t.b, t.c)) - half_pixel) >> 8, size - 1);
    return box;
}

ivec2 tiles_of(PixelBox box) {
    return box.high / tile_side - box.low / tile_side + 1;
}

/// The edges and the depth at a pixel, with their steps; good for the tile_side pixels to the right
/// of it and below.
struct Walk {
    ivec3 edges, right, down;
    float depth, depth_right, depth_down, nearest, farthest;
};

int64_t edge_at(ivec2 from, ivec2 to, ivec2 point) {
    return cross_64(to - from, point - from);
}

int step_value(int64_t edge, ivec2 along) {
    bool top_left = along.y < 0 || (along.y == 0 && along.x > 0);
    const int64_t bound = int64_t(1) << 30;
    return int(clamp((edge - (top_left ? 0 : 1)) >> 8, -bound, bound));
}

Walk walk_at(Triangle t, ivec2 pixel) {
    ivec2 point = pixel * subpixels + subpixels / 2;
    ivec2 ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c;
    int64_t e_ab = edge_at(t.a, t.b, point);
    int64_t e_bc = edge_at(t.b, t.c, point);
    int64_t e_ca = edge_at(t.c, t.a, point);
    Walk walk;
    walk.edges = ivec3(step_value(e_ab, ab), step_value(e_bc, bc), step_value(e_ca, ca));
    walk.right = -ivec3(ab.y, bc.y, ca.y);
    walk.down = ivec3(ab.x, bc.x, ca.x);
    float area = float(cross_64(ab, t.c - t.a));
    float to_b = (t.depth_b - t.depth_a) / area, to_c = (t.depth_c - t.depth_a) / area;
    walk.depth = t.depth_a + float(e_ca) * to_b + float(e_ab) * to_c;
    walk.depth_right = -(float(ca.y) * to_b + float(ab.y) * to_c) * float(subpixels);
    walk.depth_down = (float(ca.x) * to_b + float(ab.x) * to_c) * float(subpixels);
    walk.nearest = min(t.depth_a, min(t.depth_b, t.depth_c));
    walk.farthest = max(t.depth_a, max(t.depth_b, t.depth_c));
    return walk;
}

bool covers(Walk walk, ivec2 offset) {
    ivec3 e = walk.edges + walk.right * offset.x + walk.down * offset.y;
    return (e.x | e.y | e.z) >= 0;
}

/// False where an edge leaves out the whole square of `side` pixels at the offset.
bool may_cover(Walk walk, ivec2 offset, int side) {
    ivec3 e = walk.edges + walk.right * offset.x + walk.down * offset.y +
              (max(walk.right, 0) + max(walk.down, 0)) * (side - 1);
    return (e.x | e.y | e.z) >= 0;
}

/// Interpolation may leave the triangle's range by rounding, far where it is a sliver.
uint64_t key_at(Walk walk, ivec2 offset, uint number) {
    float depth = walk.depth + walk.depth_right * float(offset.x) +
                  walk.depth_down * float(offset.y);
    depth = clamp(depth, walk.nearest, walk.farthest);
    return uint64_t(floatBitsToUint(depth)) << 32 | uint64_t(~number);
}
#endif
