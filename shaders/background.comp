// The background alone, over which surfaces are drawn.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#include "common/brdf.glsl"
#include "common/environment.glsl"
#include "common/seen.glsl"
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
#include "common/lighting_constants.glsl"
layout(binding = 0) uniform Views { View view; };
layout(binding = 1) uniform Environments { Environment environment; };
layout(binding = 2) writeonly uniform image2D target;
#define SURROUNDINGS_BINDING 3
#include "common/surroundings.glsl"
#include "common/background.glsl"

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    vec3 ray = ray_at(view, vec2(at) + 0.5, vec2(size));
    vec3 light = background_at(normalize(ray), float(size.y));
    imageStore(target, at, vec4(round_to_half(light), 1.0));
}
