// The same as finish.comp with lattices of 16 nodes read from shared memory: each group copies the
// lattices once and then finishes a run of tiles, two texels of each a thread.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 32, local_size_y = 32) in;

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

    ivec2 size = textureSize(picture, 0);
    ivec2 group = ivec2(gl_WorkGroupSize.xy), tile = group * ivec2(2, 1);
    int columns = (size.x + tile.x - 1) / tile.x;
    int tiles = columns * ((size.y + tile.y - 1) / tile.y);
    int groups = int(gl_NumWorkGroups.x);
    int run = (tiles + groups - 1) / groups;
    int first = int(gl_WorkGroupID.x) * run;
    int count = min(run, tiles - first);
    ivec2 place = ivec2(first % columns, first / columns);
    for (int i = 0; i < count; ++i) {
        ivec2 left = place * tile + ivec2(gl_LocalInvocationID.xy);
        ivec2 right = left + ivec2(group.x, 0);
        vec3 left_c = display_encoded(min(left, size - 1));
        vec3 right_c = display_encoded(min(right, size - 1));
        if (left.y < size.y) {
            if (left.x < size.x)
                store_texel(left, size, left_c);
            if (right.x < size.x)
                store_texel(right, size, right_c);
        }
        place = place.x + 1 < columns ? ivec2(place.x + 1, place.y) : ivec2(0, place.y + 1);
    }
}
