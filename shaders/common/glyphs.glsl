// A few characters for graticules, five dots wide and six high, rows from the top in bits 29 to 0.
const uint glyph_r = 10u, glyph_g = 11u, glyph_b = 12u, glyph_c = 13u, glyph_m = 14u, glyph_y = 15u,
           glyph_l = 16u;
const uint glyphs[17] = uint[17](
    488232750u, 146935950u, 487657759u, 1008141870u, 73747426u, 1057949230u, 487540270u,
    1041305864u, 488064558u, 488160302u, // the figures
    1025047121u, 488136238u, 1025459774u, 488129070u, 599442993u, 581046404u, 554189343u);
const int glyph_height = 6, glyph_step = 6;

/// Whether the texel `at`, relative to the glyph's upper left corner, is part of it.
bool in_glyph(ivec2 at, uint glyph, int dot_size) {
    ivec2 cell = ivec2(floor(vec2(at) / float(dot_size)));
    if (any(lessThan(cell, ivec2(0))) || cell.x > 4 || cell.y >= glyph_height) {
        return false;
    }
    return (glyphs[glyph] >> (29 - cell.y * 5 - cell.x) & 1u) != 0u;
}

/// The same of a number of up to three figures whose upper right corner is the origin.
bool in_label(ivec2 at, uint number, int dot_size) {
    int width = glyph_step * dot_size;
    for (int place = 1; place <= 3; ++place) {
        if (in_glyph(at + ivec2(place * width, 0), number % 10u, dot_size)) {
            return true;
        }
        number /= 10u;
        if (number == 0u) {
            break;
        }
    }
    return false;
}
