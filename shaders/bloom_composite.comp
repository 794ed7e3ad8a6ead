// Light with its bloom, before exposure and tone map.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/finish.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 13) writeonly uniform image2D composite;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, imageSize(composite)))) {
        vec3 light = bloomed(at, picture_at(at));
        imageStore(composite, at, vec4(round_to_half(min(light, half_max)), 1.0));
    }
}
