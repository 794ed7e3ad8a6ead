// A separable Gaussian along one axis: the centre, then pairs of neighbours, each pair one bilinear
// fetch on either side. Weights come from preview/finish/blooms.cpp.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/stored.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const int tap_count = 1;
layout(constant_id = 1) const bool along_x = true;
layout(constant_id = 2) const bool has_own = false;
layout(constant_id = 3) const int stored = 0;

layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D own;
layout(binding = 2) uniform Taps { vec4 taps[32]; };
layout(binding = 3) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float keep, own_scale; // of own
};

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    vec2 texel = 1.0 / vec2(textureSize(source, 0));
    vec2 centre = (vec2(at) + 0.5) * texel;
    // By component: Mesa 22.3 folds a choice between two constant vectors by a specialisation
    // constant wrongly.
    vec2 along = vec2(along_x ? texel.x : 0.0, along_x ? 0.0 : texel.y);
    vec3 sum = texelFetch(source, at, 0).rgb * taps[0].z;
    for (int i = 1; i < tap_count; ++i) {
        vec2 offset = along * taps[i].x;
        sum += (textureLod(source, centre + offset, 0.0).rgb +
                textureLod(source, centre - offset, 0.0).rgb) *
               taps[i].z;
    }
    if (has_own) {
        vec2 from = (vec2(at) + 0.5) * own_scale / vec2(textureSize(own, 0));
        sum += textureLod(own, from, 0.0).rgb * keep;
    }
    imageStore(target, at, vec4(as_stored(sum, stored), 1.0));
}
