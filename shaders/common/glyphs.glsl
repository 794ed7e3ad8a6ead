// Characters for graticules and names, five dots wide and six high, rows from the top in bits 29
// to 0.
// In the order of glyph_of() of preview/passes/glyphs.cpp: figures, letters, then . - _ + : ?
const uint glyphs[42] = uint[42](
    488232750u, 146935950u, 487657759u, 1008141870u, 73747426u, 1057949230u, 487540270u,
    1041305864u, 488064558u, 488160302u, 488177201u, 1025459774u, 488129070u, 1025033790u,
    1057964575u, 1057964560u, 488136238u, 589284913u, 474091662u, 237046348u, 590238289u,
    554189343u, 599442993u, 597347889u, 488162862u, 1025047056u, 488166989u, 1025047121u,
    520553534u, 1044516996u, 588826158u, 588818756u, 588961649u, 581046609u, 581046404u,
    1042424351u, 396u, 1015808u, 31u, 4357252u, 12976524u, 487657476u);
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
