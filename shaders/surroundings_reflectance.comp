// What GGX with height-correlated masking reflects of a white sphere of directions: scale and bias
// of f0 (the second sum of Karis 2013, "Real shading in Unreal Engine 4"). The cosine to the eye
// goes from 0 to 1 along x, perceptual roughness along y, both with nodes at their ends.
// preview/reference/surroundings.h is the same in double.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/brdf.glsl"
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) writeonly uniform image2D target;

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    float n_dot_v = max(float(at.x) / float(size.x - 1), 0.001);
    float alpha = max(float(at.y) / float(size.y - 1), least_roughness);
    alpha *= alpha;
    vec3 to_eye = vec3(sqrt(1.0 - n_dot_v * n_dot_v), 0.0, n_dot_v);
    const int steps = 64;
    vec2 sum = vec2(0.0);
    // Halfway vectors in equal shares of the distribution's n.h (Walter et al. 2007).
    for (int i = 0; i < steps; ++i) {
        float share = (float(i) + 0.5) / float(steps);
        float squared = (1.0 - share) / (1.0 + (alpha * alpha - 1.0) * share);
        float across = sqrt(max(1.0 - squared, 0.0));
        float n_dot_h = sqrt(squared);
        for (int k = 0; k < steps; ++k) {
            float turn = pi * (float(k) + 0.5) / float(steps); // the other half is the same
            float v_dot_h = to_eye.x * across * cos(turn) + to_eye.z * n_dot_h;
            float n_dot_l = 2.0 * v_dot_h * n_dot_h - n_dot_v;
            if (v_dot_h > 0.0 && n_dot_l > 0.0) {
                float weight = 4.0 * smith_visibility(n_dot_l, n_dot_v, alpha) * n_dot_l * v_dot_h /
                               n_dot_h;
                float grazing = 1.0 - v_dot_h;
                float fresnel = grazing * grazing * grazing * grazing * grazing;
                sum += weight * vec2(1.0 - fresnel, fresnel);
            }
        }
    }
    imageStore(target, at, vec4(round_to_half(vec3(sum / float(steps * steps), 0.0)), 1.0));
}
