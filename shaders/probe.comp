// One texel's display-encoded colour before the looks, and after each side's.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/finish.glsl"
#include "common/graded.glsl"
layout(local_size_x = 1) in;
layout(binding = 15) uniform Place { ivec2 at; } place;
layout(binding = 16) writeonly buffer Probed { vec4 before, a, b; } probed;

void main() {
    vec3 c = display_encoded(place.at, picture_at(place.at));
    probed.before = vec4(c, 0.0);
    probed.a = vec4(graded_a(c), 0.0);
    probed.b = vec4(graded_b(c), 0.0);
}
