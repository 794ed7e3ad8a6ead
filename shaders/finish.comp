// Bloom's last filter, tone map, looks and comparison (common/finish.glsl), a texel a thread.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;

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

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = textureSize(picture, 0);
    if (all(lessThan(at, size)))
        store_texel(at, size, display_encoded(at));
}
