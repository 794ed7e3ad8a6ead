// A lattice of 16 nodes a side with codes of 8 bits, held in shared memory: 16 KB.
//
// Interpolation works on whole codes in float, almost without conversion instructions, of which GPUs
// have few: a float of exponent e holds an integer in its mantissa, so that OR-ing an exponent onto
// a masked field gives 2^e + code, and the differences of such numbers are exact.
#include "common/sanitise.glsl"

const int lattice_nodes = 16 * 16 * 16;

// Green takes bits 7..14, blue 15..22, red 24..31; each sits where its exponent wants it.
uint pack_node(vec3 unorm) {
    uvec3 code = uvec3(unorm * 255.0 + 0.5);
    return code.g << 7 | code.b << 15 | code.r << 24;
}

const vec3 node_bias = vec3(0.0, 65536.0, 256.0);

vec3 unpack_node(uint node) {
    return vec3(float(node >> 24), uintBitsToFloat(0x47800000u | node & 0x7F80u),
                uintBitsToFloat(0x43800000u | node & 0x7F8000u));
}

// The cell of each channel and the fraction in it. Adding 1.5 * 2^23 rounds to an integer, which
// then stands in the low bits; half a node less makes that the cell. A value on a node may land in
// either of its cells, at fraction 0 or 1.
struct Cell16 {
    uint node;
    vec3 f;
};

/// `c` within 0..1.
Cell16 cell16_of(vec3 c) {
    const float magic = 12582912.0;
    precise vec3 shifted = fma(c, vec3(15.0), vec3(-0.5)) + magic;
    precise vec3 whole = shifted - magic;
    uvec3 cell = floatBitsToUint(shifted);
    return Cell16((cell.r + (cell.g << 4) + (cell.b << 8)) & 0xFFFu, fma(c, vec3(15.0), -whole));
}
