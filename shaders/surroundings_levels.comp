// The surroundings as surfaces of rising roughness mirror them: pictures of all directions one
// below the other, each texel the mean of the base under a GGX lobe seen along its axis (Karis
// 2013, "Real shading in Unreal Engine 4"), summed over every texel of the base.
// preview/reference/surroundings.h is the same in double.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
#include "common/sphere.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D base;
layout(binding = 1) writeonly uniform image2D target;

const int held = 256;
shared vec4 held_directions[held]; // w: solid angle
shared vec3 held_radiances[held];

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = textureSize(base, 0); // of a level too
    ivec2 target_size = imageSize(target);
    int levels = target_size.y / size.y;
    int level = min(at.y / size.y, levels - 1);
    float roughness = float(level + 1) / float(levels);
    float alpha2 = roughness * roughness * roughness * roughness;
    ivec2 place = ivec2(at.x, at.y - level * size.y);
    vec3 axis = sphere_direction((vec2(place) + 0.5) / vec2(size));
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    int texels = size.x * size.y;
    for (int first = 0; first < texels; first += held) {
        int mine = first + int(gl_LocalInvocationIndex);
        ivec2 texel = ivec2(mine % size.x, mine / size.x);
        bool is_there = mine < texels;
        held_directions[gl_LocalInvocationIndex] =
            vec4(sphere_direction((vec2(texel) + 0.5) / vec2(size)),
                 is_there ? sphere_texel(texel.y, size) : 0.0);
        held_radiances[gl_LocalInvocationIndex] =
            is_there ? texelFetch(base, texel, 0).rgb : vec3(0.0);
        barrier();
        for (int i = 0; i < held; ++i) {
            vec4 towards = held_directions[i];
            float cosine = dot(axis, towards.xyz);
            // The square of n.h, where h halves the way from the axis to the direction.
            float squared = 0.5 + 0.5 * cosine;
            float d = squared * (alpha2 - 1.0) + 1.0;
            float weight = max(cosine, 0.0) * towards.w / (d * d);
            sum += weight * held_radiances[i];
            weights += weight;
        }
        barrier();
    }
    if (all(lessThan(at, target_size))) {
        imageStore(target, at, vec4(round_to_half(sum / max(weights, 1e-20)), 1.0));
    }
}
