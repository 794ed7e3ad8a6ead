// The irradiance of the surroundings as spherical harmonics up to order 2, a group for each of the
// nine. Ramamoorthi and Hanrahan 2001, "An efficient representation for irradiance environment
// maps". preview/reference/surroundings.h is the same in double.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/harmonics.glsl"
#include "common/sphere.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D base;
layout(std430, binding = 1) writeonly buffer Harmonics { vec4 harmonics[]; };

shared vec3 sums[256];

void main() {
    uint me = gl_LocalInvocationIndex;
    int which = int(gl_WorkGroupID.x);
    ivec2 size = textureSize(base, 0);
    vec3 sum = vec3(0.0);
    for (int texel = int(me); texel < size.x * size.y; texel += 256) {
        ivec2 at = ivec2(texel % size.x, texel / size.x);
        vec3 direction = sphere_direction((vec2(at) + 0.5) / vec2(size));
        sum += texelFetch(base, at, 0).rgb * (sphere_texel(at.y, size) * harmonic(which, direction));
    }
    sums[me] = sum;
    barrier();
    for (uint step = 128; step > 0; step /= 2) {
        if (me < step) {
            sums[me] += sums[me + step];
        }
        barrier();
    }
    if (me == 0) {
        harmonics[which] = vec4(sums[0] * cosine_lobe(which), 0.0);
    }
}
