// Shows an image as colours; the modes are ViewMode of preview/passes/view.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/srgb.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int mode = 0;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size)))
        return;
    vec4 texel = texelFetch(source, at * textureSize(source, 0) / size, 0);
    vec3 colour = texel.rgb;
    if (mode == 0)
        colour = srgb_encode(saturate(colour));
    else if (mode == 2) // depth is 1 - near / z; ten doublings of z from white to black
        colour = vec3(texel.r < 1.0 ? 1.0 + log2(1.0 - texel.r) / 10.0 : 0.0);
    imageStore(target, at, vec4(saturate(colour), 1.0));
}
