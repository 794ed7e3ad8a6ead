// The looks of both sides, each from its own picture or table.
#include "common/finish.glsl"

vec3 graded_a(vec3 c) {
    return apply_lookup(lookup_a, picture_a, volume_a, shaper_a, look_a, c);
}

vec3 graded_b(vec3 c) {
    return apply_lookup(lookup_b, picture_b, volume_b, shaper_b, look_b, c);
}
