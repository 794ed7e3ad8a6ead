// The body of finish_shared.comp and finish_shared_half.comp: as finish.comp, with one look of 16
// nodes in shared memory. There are as many groups as the GPU holds at once; each copies the
// lattice and then finishes tiles of the picture, a stride apart, until it ends.
layout(local_size_x = 8, local_size_y = 128) in;

#include "common/finish.glsl"
#include "rows/shared_lookups.glsl"

/// What a look at this place gets lies within 0..1: a tone map's result, and what an integer format
/// holds, as they are.
bool is_unit(int place) {
    return (place & (stands_before | opens)) == 0 && (tonemap_row >= 0 || unit_picture);
}

vec3 looked_up_a(vec3 c) {
    if (is_shared(lookup_a)) {
        return shared_lookup(lookup_a, is_unit(place_a) ? c : saturate(c));
    }
    return apply_lookup(lookup_a, picture_a, volume_a, shaper_a, look_a, c);
}

// There is shared memory for one lattice only; the second is read from its picture.
vec3 looked_up_b(vec3 c) {
    if (is_shared(lookup_b) && !is_shared(lookup_a)) {
        return shared_lookup(lookup_b, is_unit(place_b) ? c : saturate(c));
    }
    return apply_lookup(lookup_b, picture_b, volume_b, shaper_b, look_b, c);
}

vec3 graded_a(Stages texel) {
    return shown_of_look(place_a, 0, tonemap_row,
                         looked_up_a(fed_to_look(place_a, 0, texel.light, texel.codes)));
}

vec3 graded_b(Stages texel) {
    return shown_of_look(place_b, 1, tonemap_row,
                         looked_up_b(fed_to_look(place_b, 1, texel.light, texel.codes)));
}

#include "common/finish_target.glsl"

const int texels_each = 4;
const ivec2 tile = ivec2(32, 128);

// `whole`: the tile lies inside the picture, so that nothing need be clamped or tested.
void finish_tile(ivec2 corner, ivec2 size, bool whole) {
    ivec2 first = corner + ivec2(gl_LocalInvocationID.xy);
    vec3 texels[texels_each];
    for (int k = 0; k < texels_each; ++k) {
        ivec2 at = first + ivec2(8 * k, 0);
        texels[k] = picture_at(whole ? at : min(at, size - 1));
    }
    for (int k = 0; k < texels_each; ++k) {
        ivec2 at = first + ivec2(8 * k, 0);
        if (whole || all(lessThan(at, size))) {
            store_texel(at, size, stages_of(at, texels[k]));
        }
    }
}

void main() {
    load_nodes();
    ivec2 size = textureSize(picture, 0);
    ivec2 tiles = (size + tile - 1) / tile;
    int groups = int(gl_NumWorkGroups.x), group = int(gl_WorkGroupID.x);
    ivec2 place = ivec2(group % tiles.x, group / tiles.x);
    ivec2 stride = ivec2(groups % tiles.x, groups / tiles.x);
    while (place.y < tiles.y) {
        if (all(lessThanEqual((place + 1) * tile, size))) {
            finish_tile(place * tile, size, true);
        } else {
            finish_tile(place * tile, size, false);
        }
        place += stride;
        if (place.x >= tiles.x) {
            place += ivec2(-tiles.x, 1);
        }
    }
}
