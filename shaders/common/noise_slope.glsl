// The noise of common/noise.glsl with its slope, for flows that follow it.
#include "common/noise.glsl"

/// Perlin noise and, in x and y, how steeply it rises along x and y: derived from its formula.
vec3 perlin_with_slope(vec3 p) {
    vec3 low = floor(p);
    vec3 f = p - low;
    ivec3 cell = ivec3(low);
    vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec2 dw = (30.0 * f * f * (f * (f - 2.0) + 1.0)).xy;
    vec3 sum = vec3(0.0); // slope, value
    for (int i = 0; i < 8; ++i) {
        ivec3 corner = ivec3(i & 1, i >> 1 & 1, i >> 2);
        ivec3 at = cell + corner;
        vec3 share = mix(1.0 - w, w, vec3(corner));
        vec2 share_slope = (2.0 * vec2(corner.xy) - 1.0) * dw;
        float value = noise_slope(at, f - vec3(corner));
        vec2 gradient = vec2(noise_slope(at, vec3(1.0, 0.0, 0.0)),
                             noise_slope(at, vec3(0.0, 1.0, 0.0)));
        sum.xy += share.z * (share.x * share.y * gradient + share_slope * share.yx * value);
        sum.z += share.x * share.y * share.z * value;
    }
    return sum;
}
