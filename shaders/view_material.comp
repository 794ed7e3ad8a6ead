// Shows a property of the material that each texel names; the modes are ViewMode of
// preview/passes/view.h.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/scene.glsl"
#include "common/srgb.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int mode = 3;
layout(binding = 0) uniform usampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(std430, binding = 2) readonly buffer Materials { Material materials[]; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size)))
        return;
    uint number = texelFetch(source, at * textureSize(source, 0) / size, 0).r;
    vec3 colour = vec3(0.0);
    if (number > 0u) {
        Material material = materials[number - 1u];
        if (mode == 3)
            colour = srgb_encode(saturate(material.albedo_roughness.rgb));
        else if (mode == 4)
            colour = material.albedo_roughness.aaa;
        else if (mode == 5)
            colour = material.emission_metalness.aaa;
        else
            colour = srgb_encode(saturate(material.emission_metalness.rgb));
    }
    imageStore(target, at, vec4(saturate(colour), 1.0));
}
