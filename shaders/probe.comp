// One texel's display-encoded colour before the looks, and after each side's; in their fourth
// numbers the light before the tone map.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/finish.glsl"
#include "common/graded.glsl"
layout(local_size_x = 1) in;
layout(binding = 13) uniform Place { ivec2 at; } place;
layout(binding = 14) writeonly buffer Probed { vec4 before, a, b; } probed;

void main() {
    Stages texel = stages_of(place.at, picture_at(place.at));
    probed.before = vec4(texel.codes, texel.light.r);
    probed.a = vec4(graded_a(texel), texel.light.g);
    probed.b = vec4(graded_b(texel), texel.light.b);
}
