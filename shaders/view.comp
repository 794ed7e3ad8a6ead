// Shows an image as colours; the modes are ViewMode of preview/passes/view.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const int mode = 0;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;

vec3 srgb_encode(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055,
               greaterThan(c, vec3(0.0031308)));
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size)))
        return;
    vec4 texel = texelFetch(source, at * textureSize(source, 0) / size, 0);
    vec3 colour = texel.rgb;
    if (mode == 0)
        colour = srgb_encode(saturate(colour));
    else if (mode == 2)
        colour = texel.rrr;
    else if (mode == 3)
        colour = texel.ggg;
    else if (mode == 4) // depth is 1 - near / z; ten doublings of z from white to black
        colour = vec3(texel.r < 1.0 ? 1.0 + log2(1.0 - texel.r) / 10.0 : 0.0);
    imageStore(target, at, vec4(saturate(colour), 1.0));
}
