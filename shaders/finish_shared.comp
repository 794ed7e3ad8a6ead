// The same as finish.comp with lattices of 16 nodes read from shared memory: each group copies the
// lattices once and then finishes a run of tiles, four texels of each a thread.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 32, local_size_y = 16) in;

vec3 graded_a(vec3 c);
vec3 graded_b(vec3 c);
#include "common/bloom.glsl"
#include "common/finish.glsl"
#include "common/lattice16.glsl"

const bool shared_a = lookup_a == lookup_shared_trilinear || lookup_a == lookup_shared_tetrahedral;
const bool shared_b = lookup_b == lookup_shared_trilinear || lookup_b == lookup_shared_tetrahedral;

shared uint nodes_a[shared_a ? lattice_nodes : 1];
shared uint nodes_b[shared_b ? lattice_nodes : 1];

// Written out for each lattice, for shared arrays are no arguments.
#define NODES nodes_a
#define TRILINEAR trilinear_a
#define TETRAHEDRAL tetrahedral_a
#include "common/lattice16_lookup.glsl"
#undef NODES
#undef TRILINEAR
#undef TETRAHEDRAL
#define NODES nodes_b
#define TRILINEAR trilinear_b
#define TETRAHEDRAL tetrahedral_b
#include "common/lattice16_lookup.glsl"

// A tone map's result, and what an integer format holds, lies within 0..1.
vec3 unit(vec3 c) {
    return tonemap_row >= 0 || unit_picture ? c : saturate(c);
}

vec3 graded_a(vec3 c) {
    if (lookup_a == lookup_shared_trilinear)
        return trilinear_a(unit(c));
    if (lookup_a == lookup_shared_tetrahedral)
        return tetrahedral_a(unit(c));
    return apply_lookup(lookup_a, picture_a, volume_a, shaper_a, look_a, c);
}

vec3 graded_b(vec3 c) {
    if (lookup_b == lookup_shared_trilinear)
        return trilinear_b(unit(c));
    if (lookup_b == lookup_shared_tetrahedral)
        return tetrahedral_b(unit(c));
    return apply_lookup(lookup_b, picture_b, volume_b, shaper_b, look_b, c);
}

const int texels_each = 4;
const ivec2 tile = ivec2(64, 32);

ivec2 size;

ivec2 tile_texel(ivec2 place, int k) {
    return place * tile + ivec2(gl_LocalInvocationID.xy) + ivec2(k & 1, k >> 1) * (tile / 2);
}

void fetch_tile(ivec2 place, out vec3 texels[texels_each]) {
    for (int k = 0; k < texels_each; ++k)
        texels[k] = picture_at(min(tile_texel(place, k), size - 1));
}

void main() {
    const uint threads = gl_WorkGroupSize.x * gl_WorkGroupSize.y;
    for (uint i = gl_LocalInvocationIndex; i < uint(lattice_nodes); i += threads) {
        ivec2 texel = ivec2(i % 16u + i / 256u * 16u, i / 16u % 16u);
        if (shared_a)
            nodes_a[i] = pack_node(texelFetch(picture_a, texel, 0).rgb);
        if (shared_b)
            nodes_b[i] = pack_node(texelFetch(picture_b, texel, 0).rgb);
    }
    barrier();

    size = textureSize(picture, 0);
    int columns = (size.x + tile.x - 1) / tile.x;
    int tiles = columns * ((size.y + tile.y - 1) / tile.y);
    int groups = int(gl_NumWorkGroups.x);
    int run = (tiles + groups - 1) / groups;
    int first = int(gl_WorkGroupID.x) * run;
    int count = min(run, tiles - first);
    ivec2 place = ivec2(first % columns, first / columns);
    // The next tile's texels are under way while this one's are finished.
    vec3 next[texels_each];
    fetch_tile(place, next);
    for (int i = 0; i < count; ++i) {
        vec3 texels[texels_each] = next;
        ivec2 here = place;
        place = place.x + 1 < columns ? ivec2(place.x + 1, place.y) : ivec2(0, place.y + 1);
        if (i + 1 < count)
            fetch_tile(place, next);
        for (int k = 0; k < texels_each; ++k) {
            ivec2 at = tile_texel(here, k);
            if (all(lessThan(at, size)))
                store_texel(at, size, display_encoded(at, texels[k]));
        }
    }
}
