// A look of 16 nodes a side with codes of 8 bits in shared memory, and its lookups. Nodes are half
// floats, which hold the codes 0..255 exactly and need no unpacking: red and green, then blue.
//
// FINISH_HALF interpolates in half floats, two channels an instruction: weights and sums are
// rounded to 11 bits, which moves a result by less than 1/2 code of 8 bits (a test holds it to one
// code after rounding). Without it the arithmetic is in floats.
#include "common/sanitise.glsl"
#ifdef FINISH_HALF
#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require
#endif

const uint lattice_nodes = 16 * 16 * 16;
const uint next_r = 1, next_g = 16, next_b = 256, next_all = next_r + next_g + next_b;

// As they come from preview/look/look_texels.cpp, two in each.
layout(std430, binding = 15) readonly buffer Nodes { uvec4 node_pairs[]; };
shared uvec2 nodes[lattice_nodes];

/// Threads are a power of two, at most half as many as there are nodes.
void load_nodes() {
    const uint threads = gl_WorkGroupSize.x * gl_WorkGroupSize.y;
    const uint pairs_each = lattice_nodes / 2 / threads;
    uvec4 pairs[pairs_each];
    for (uint k = 0; k < pairs_each; ++k) {
        pairs[k] = node_pairs[gl_LocalInvocationIndex + k * threads];
    }
    for (uint k = 0; k < pairs_each; ++k) {
        uint first = 2 * (gl_LocalInvocationIndex + k * threads);
        nodes[first] = pairs[k].xy;
        nodes[first + 1] = pairs[k].zw;
    }
    barrier();
}

vec3 codes_at(uint node) {
    uvec2 halves = nodes[node];
    return vec3(unpackHalf2x16(halves.x), unpackHalf2x16(halves.y).x);
}

// The cell of each channel, and where in it a colour lies, -1/2..1/2. Adding 1.5 * 2^23 rounds to
// an integer, which then stands in the low bits; half a node less makes that the cell. A value on a
// node may land in either of its cells, on its border.
struct Cell16 {
    uint node;
    vec3 from_middle;
};

/// `c` within 0..1.
Cell16 cell16_of(vec3 c) {
    const float magic = 12582912.0;
    precise vec3 at = fma(c, vec3(15.0), vec3(-0.5));
    precise vec3 shifted = at + magic;
    precise vec3 cell = shifted - magic;
    precise float node = fma(cell.b, float(next_b), fma(cell.g, float(next_g), shifted.r));
    precise vec3 from_middle = at - cell;
    return Cell16(floatBitsToUint(node) & 0xFFFu, from_middle);
}

#ifdef FINISH_HALF
/// The sum of four nodes by weights that add up to 1/255.
vec3 weighted(uvec4 places, vec4 weights) {
    f16vec2 red_green = f16vec2(0.0);
    float16_t blue = float16_t(0.0);
    for (int i = 0; i < 4; ++i) {
        uvec2 halves = nodes[places[i]];
        float16_t weight = float16_t(weights[i]);
        red_green = fma(unpackFloat2x16(halves.x), f16vec2(weight), red_green);
        blue = fma(unpackFloat2x16(halves.y).x, weight, blue);
    }
    return vec3(red_green, blue) * (1.0 / 255.0);
}
#else
vec3 weighted(uvec4 places, vec4 weights) {
    vec3 codes = codes_at(places.x) * weights.x;
    for (int i = 1; i < 4; ++i) {
        codes = fma(codes_at(places[i]), vec3(weights[i]), codes);
    }
    return codes * (1.0 / 255.0);
}
#endif

vec3 tetrahedral16(vec3 c) {
    Cell16 cell = cell16_of(c);
    vec3 f = cell.from_middle;
    float larger = max(f.r, f.g), smaller = min(f.r, f.g);
    float high = max(larger, f.b), low = min(smaller, f.b);
    float middle = max(smaller, min(larger, f.b));
    // In the opposite order, so that of equal fractions the first and the last differ.
    uint first = f.r == high ? next_r : f.g == high ? next_g : next_b;
    uint last = f.b == low ? next_b : f.g == low ? next_g : next_r;
    return weighted(uvec4(0, first, next_all - last, next_all) + cell.node,
                    vec4(0.5 - high, high - middle, middle - low, 0.5 + low));
}

vec3 trilinear16(vec3 c) {
    Cell16 cell = cell16_of(c);
    vec3 f = cell.from_middle + 0.5;
    vec3 rows[4];
    for (uint i = 0; i < 4; ++i) {
        uint at = cell.node + (i & 1) * next_g + (i >> 1) * next_b;
        vec3 low = codes_at(at);
        rows[i] = fma(codes_at(at + next_r) - low, vec3(f.r), low);
    }
    vec3 near = fma(rows[1] - rows[0], vec3(f.g), rows[0]);
    vec3 far = fma(rows[3] - rows[2], vec3(f.g), rows[2]);
    return fma(far - near, vec3(f.b), near) * (1.0 / 255.0);
}
