// The looks of both sides, each from its own picture or table.
#include "common/finish.glsl"

vec3 graded_a(Stages texel) {
    vec3 c = fed_to_look(place_a, 0, texel.light, texel.codes);
    return shown_of_look(place_a, 0, tonemap_row,
                         apply_lookup(lookup_a, picture_a, volume_a, shaper_a, look_a, c));
}

vec3 graded_b(Stages texel) {
    vec3 c = fed_to_look(place_b, 1, texel.light, texel.codes);
    return shown_of_look(place_b, 1, tonemap_row,
                         apply_lookup(lookup_b, picture_b, volume_b, shaper_b, look_b, c));
}
