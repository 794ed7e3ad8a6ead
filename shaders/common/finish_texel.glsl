// For passes that finish texels and keep no picture of them: what common/finish.glsl needs beside
// itself. They bind their own resources from binding 15 on, in place of finish.glsl's, which they
// must not touch.
vec3 graded_a(vec3 c);
vec3 graded_b(vec3 c);
#include "common/bloom.glsl"
#include "common/finish.glsl"

vec3 graded_a(vec3 c) {
    return apply_lookup(lookup_a, picture_a, volume_a, shaper_a, look_a, c);
}

vec3 graded_b(vec3 c) {
    return apply_lookup(lookup_b, picture_b, volume_b, shaper_b, look_b, c);
}
