// What the scopes count by (preview/finish/scopes.h), in integers: 8-bit codes, and BT.709's luma
// and colour differences of them with weights in 65536ths. preview/reference/scopes.cpp is the
// twin.
const uint levels = 256u;

/// Of an rgba8 texel, exactly.
uvec3 codes_of(vec3 texel) {
    return uvec3(clamp(texel, 0.0, 1.0) * 255.0 + 0.5);
}

uint luma_of(uvec3 c) {
    return (13933u * c.r + 46871u * c.g + 4732u * c.b + 32768u) >> 16;
}

/// Cb and Cr, neutral at 128.
uvec2 chroma_of(uvec3 codes) {
    ivec3 c = ivec3(codes);
    ivec2 differences = ivec2(-7509 * c.r - 25259 * c.g + 32768 * c.b,
                              32768 * c.r - 29763 * c.g - 3005 * c.b);
    return uvec2(min((differences + 32768 >> 16) + 128, ivec2(255)));
}
