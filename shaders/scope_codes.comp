// Turns a picture's codes into those of the same colours in another encoding, for the scopes that
// count levels. Exact: light is a whole number of 64 bits, and a level begins at one
// (preview/finish/scope_codes.h). preview/reference/scopes.cpp is the twin.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 16, local_size_y = 16) in;
#include "common/scope.glsl"

layout(binding = 0) uniform sampler2D picture;
layout(std430, binding = 1) readonly buffer Tables {
    uvec2 darkest, brightest; // low word, high word
    uvec2 light[3u * 3u * levels];
    uvec2 rises[levels];
} tables;
layout(binding = 2) writeonly uniform image2D target;

bool less_than(uvec2 a, uvec2 b) {
    return a.y == b.y ? a.x < b.x : int(a.y) < int(b.y);
}

uvec2 added(uvec2 a, uvec2 b) {
    uint carry;
    uint low = uaddCarry(a.x, b.x, carry);
    return uvec2(low, a.y + b.y + carry);
}

uint level_of(uint channel, uvec3 codes) {
    uvec2 light = uvec2(0u);
    for (uint from = 0u; from < 3u; ++from) {
        light = added(light, tables.light[(3u * channel + from) * levels + codes[from]]);
    }
    light = less_than(light, tables.darkest) ? tables.darkest : light;
    light = less_than(tables.brightest, light) ? tables.brightest : light;
    uint level = 0u;
    for (uint step = levels / 2u; step > 0u; step /= 2u) {
        level += less_than(light, tables.rises[level + step]) ? 0u : step;
    }
    return level;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    uvec3 codes = codes_of(texelFetch(picture, at, 0).rgb);
    uvec3 encoded = uvec3(level_of(0u, codes), level_of(1u, codes), level_of(2u, codes));
    imageStore(target, at, vec4(vec3(encoded) / 255.0, 1.0));
}
