// Lookups in the shared lattice NODES (common/lattice16.glsl); included once for each.

vec3 TETRAHEDRAL(vec3 c) {
    Cell16 cell = cell16_of(c);
    vec3 f = cell.f;
    float larger = max(f.r, f.g), smaller = min(f.r, f.g);
    float high = max(larger, f.b), low = min(smaller, f.b);
    float middle = max(smaller, min(larger, f.b));
    // In the opposite order, so that of equal fractions the first and the last differ.
    uint first = f.r == high ? 1u : f.g == high ? 16u : 256u;
    uint last = f.b == low ? 256u : f.g == low ? 16u : 1u;
    precise vec3 n0 = unpack_node(NODES[cell.node]);
    precise vec3 n1 = unpack_node(NODES[cell.node + first]);
    precise vec3 n2 = unpack_node(NODES[cell.node + 273u - last]);
    precise vec3 n3 = unpack_node(NODES[cell.node + 273u]);
    precise vec3 code = n0 - node_bias;
    precise vec3 d1 = n1 - n0, d2 = n2 - n1, d3 = n3 - n2;
    code = fma(d3, vec3(low), fma(d2, vec3(middle), fma(d1, vec3(high), code)));
    return code * (1.0 / 255.0);
}

vec3 TRILINEAR(vec3 c) {
    Cell16 cell = cell16_of(c);
    vec3 rows[4];
    for (uint i = 0; i < 4u; ++i) {
        uint at = cell.node + (i & 1u) * 16u + (i >> 1) * 256u;
        precise vec3 low = unpack_node(NODES[at]);
        precise vec3 high = unpack_node(NODES[at + 1u]);
        precise vec3 code = low - node_bias, step = high - low;
        rows[i] = fma(step, vec3(cell.f.r), code);
    }
    vec3 near = fma(rows[1] - rows[0], vec3(cell.f.g), rows[0]);
    vec3 far = fma(rows[3] - rows[2], vec3(cell.f.g), rows[2]);
    return fma(far - near, vec3(cell.f.b), near) * (1.0 / 255.0);
}
