// A tone map that treats the channels apart, from its table (preview/finish/tonemaps.h, ToneCurve).
layout(std430, binding = 11) readonly buffer ToneCurve { float nodes[]; } curve;

const float curve_lowest = 9.094947e-13; // 2^-40
const uint curve_node_bits = 17u;        // 64 nodes in an octave's 2^23 floats

// The bits of a float count evenly within an octave and go on with the next.
float tone_curve(float light) {
    uint at = floatBitsToUint(max(light, curve_lowest)) - floatBitsToUint(curve_lowest);
    uint node = at >> curve_node_bits;
    float share = ldexp(float(at & (1u << curve_node_bits) - 1u), -int(curve_node_bits));
    return min(mix(curve.nodes[node], curve.nodes[node + 1u], share), 1.0);
}

vec3 tone_curve(vec3 light) {
    return vec3(tone_curve(light.r), tone_curve(light.g), tone_curve(light.b));
}
