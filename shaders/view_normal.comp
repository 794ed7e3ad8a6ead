// Shows octahedral normals as n / 2 + 1/2.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform usampler2D source;
layout(binding = 1) writeonly uniform image2D target;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size)))
        return;
    uvec2 bits = texelFetch(source, at * textureSize(source, 0) / size, 0).xy;
    vec3 normal = bits == uvec2(0) ? vec3(-1.0) : decode_octahedral(from_bits(bits));
    imageStore(target, at, vec4(normal * 0.5 + 0.5, 1.0));
}
