// One texel's display-encoded colour before the looks, and after each side's; in their fourth
// numbers the light before the tone map.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/finish.glsl"
#include "common/graded.glsl"
layout(local_size_x = 1) in;
layout(constant_id = 10) const bool is_still_a = false; // a still in place of the look
layout(constant_id = 11) const bool is_still_b = false;
// A buffer, as Mesa's software device (22.3) writes beyond its stack where a branch hangs on more than
// four numbers of a uniform block and nothing else.
layout(std430, binding = 13) readonly buffer Place {
    ivec4 at; // x, y
    ivec4 extent_a, extent_b; // corner and size of the stills
    vec4 surround; // about them, a code
} place;
layout(binding = 14) writeonly buffer Probed { vec4 before, a, b; } probed;
layout(binding = 15) uniform sampler2D still_a;
layout(binding = 16) uniform sampler2D still_b;

vec3 of_still(sampler2D still, ivec2 at, ivec4 extent) {
    bool is_in = all(greaterThanEqual(at, extent.xy)) && all(lessThan(at, extent.xy + extent.zw));
    return is_in ? texelFetch(still, at, 0).rgb : place.surround.rgb;
}

void main() {
    ivec2 at = place.at.xy;
    Stages texel = stages_of(at, picture_at(at));
    probed.before = vec4(texel.codes, texel.light.r);
    probed.a = vec4(is_still_a ? of_still(still_a, at, place.extent_a) : graded_a(texel),
                    texel.light.g);
    probed.b = vec4(is_still_b ? of_still(still_b, at, place.extent_b) : graded_b(texel),
                    texel.light.b);
}
