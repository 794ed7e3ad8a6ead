// Where a pixel's key lies: blocks of 8x8 pixels, row by row.
uint key_index(ivec2 pixel, ivec2 size) {
    uint blocks = uint(size.x + 7) / 8u;
    uvec2 p = uvec2(pixel);
    return ((p.y >> 3) * blocks + (p.x >> 3)) * 64u + (p.y & 7u) * 8u + (p.x & 7u);
}

/// Up to 64 triangles of one draw; the triangle `number` is number % 64 of cluster number / 64.
struct Cluster {
    uint first_index;
    int vertex_offset;
    uint object;
    uint triangle_count;
};
