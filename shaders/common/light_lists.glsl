// Which lights reach the surfaces that a group of 16x16 pixels shows: those whose reach and cone touch
// the sphere about the surfaces; without either they reach everything. What is left out would have
// lit nothing.
// After common/scene.glsl; `lights` and `light_count` are those of the frame.
#include "common/lighting_constants.glsl"

const uint most_listed = 1024u; // of preview/passes/lighting.h

shared uint reaching[most_listed / 32u]; // bits, by light
shared uint listed[most_listed];
shared uint listed_count;
shared int lowest[3], highest[3]; // of the surfaces' places, in the order of floats

/// In the order of floats as integers; its own inverse.
int ordered(int bits) {
    return bits < 0 ? bits ^ 0x7FFFFFFF : bits;
}

/// Whether the light's reach and cone touch a sphere, and a thousandth around it for the sake of
/// rounding. Wronski 2017, "Cull that cone!".
bool touches(Light light, vec3 centre, float radius) {
    float scale = light.axis_scale.w, cosine = -light.range.x / scale;
    vec3 from = centre - light.position_layer.xyz;
    radius += 1e-3 * (radius + length(from)) + 1e-4;
    if (has_ends && light.forward.w > 0.0 && length(from) > radius + inversesqrt(light.forward.w)) {
        return false;
    }
    if (!(scale > 0.0) || !(cosine > 0.0) || !(dot(from, from) < 1e30)) {
        return true; // no spot, or one of more than half of all directions
    }
    float along = dot(from, light.axis_scale.xyz);
    float beside = sqrt(max(dot(from, from) - along * along, 0.0));
    return along > -radius &&
           cosine * beside - sqrt(max(1.0 - cosine * cosine, 0.0)) * along < radius;
}

/// Every invocation of the group calls it. `shows`: there is a surface at `position` that takes
/// light.
void list_lights(bool shows, vec3 position) {
    uint thread = gl_LocalInvocationIndex;
    uint words = (light_count + 31u) / 32u;
    if (thread < words) {
        reaching[thread] = 0u;
    }
    if (thread < 3u) {
        lowest[thread] = 0x7FFFFFFF;
        highest[thread] = -0x7FFFFFFF;
    }
    if (thread == 0u) {
        listed_count = 0u;
    }
    barrier();
    if (shows) {
        for (int axis = 0; axis < 3; ++axis) {
            int place = ordered(floatBitsToInt(position[axis]));
            atomicMin(lowest[axis], place);
            atomicMax(highest[axis], place);
        }
    }
    barrier();
    if (lowest[0] > highest[0]) {
        return; // of the sky, or of what no light changes: alike for the whole group
    }
    vec3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = intBitsToFloat(ordered(lowest[axis]));
        high[axis] = intBitsToFloat(ordered(highest[axis]));
    }
    vec3 centre = 0.5 * (low + high);
    float radius = length(high - centre);
    for (uint index = thread; index < light_count; index += 256u) {
        if (touches(lights[index], centre, radius)) {
            atomicOr(reaching[index / 32u], 1u << index % 32u);
        }
    }
    barrier();
    // In their order, so that sums are the same to the bit.
    if (thread < words) {
        uint at = 0u;
        for (uint word = 0u; word < thread; ++word) {
            at += uint(bitCount(reaching[word]));
        }
        for (uint bits = reaching[thread]; bits != 0u; bits &= bits - 1u) {
            listed[at++] = thread * 32u + uint(findLSB(bits));
        }
        if (thread + 1u == words) {
            listed_count = at;
        }
    }
    barrier();
}
