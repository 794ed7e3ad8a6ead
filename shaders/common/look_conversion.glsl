// What is converted around a look: scene light or the picture's codes to the codes that it takes, and
// what it gives to light or to the picture. The curves are those of lutlib/color/rows, in pieces of
// cubic polynomials (preview/look/cubic_curve.h). Who includes this has included tonemaps.
#include "common/sanitise.glsl"
#include "common/srgb.glsl"

// Of preview/look/look_conversion.h, PlaceBits.
const int stands_before = 1, encodes = 2, decodes = 4, gives_picture = 8, opens = 16;

const int light_pieces = 2561, code_pieces = 1024; // CubicCurve
const int first_light_piece = 7;                   // after two matrices and the range of codes
const int first_code_piece = first_light_piece + 2 * light_pieces;
const int first_picture_piece = first_code_piece + code_pieces; // of the picture's codes
const int rows_a_look = first_picture_piece + code_pieces;
const float smallest_light = 5.9604645e-8; // 2^-24
const int piece_bits = 17;                 // 64 pieces in an octave's 2^23 floats

/// Rows of both sides, A's first.
layout(std430, binding = 12) readonly buffer Conversions { vec4 rows[]; } conversions;

vec3 by_matrix(int first, vec3 c) {
    return vec3(dot(conversions.rows[first].rgb, c), dot(conversions.rows[first + 1].rgb, c),
                dot(conversions.rows[first + 2].rgb, c));
}

float piece_at(int row, float t) {
    vec4 c = conversions.rows[row];
    return c.x + t * (c.y + t * (c.z + t * c.w));
}

float encoded(int base, float light) {
    float size = min(abs(light), half_max);
    int piece = 0;
    float t = size / smallest_light;
    if (size >= smallest_light) {
        uint bits = floatBitsToUint(size) - floatBitsToUint(smallest_light);
        piece = 1 + int(bits >> piece_bits);
        t = ldexp(float(bits & (1u << piece_bits) - 1u), -piece_bits);
    }
    return piece_at(base + first_light_piece + (light < 0.0 ? light_pieces : 0) + piece, t);
}

float decoded(int first, vec2 range, float code) {
    float x = saturate((code - range.x) / (range.y - range.x)) * float(code_pieces);
    int piece = min(int(x), code_pieces - 1);
    return piece_at(first + piece, x - float(piece));
}

vec3 decoded(int first, vec2 range, vec3 codes) {
    return vec3(decoded(first, range, codes.r), decoded(first, range, codes.g),
                decoded(first, range, codes.b));
}

/// What a look at this place gets of a texel's light, or of its codes behind the tone map.
vec3 fed_to_look(int place, int side, vec3 light, vec3 codes) {
    if ((place & (stands_before | opens)) == 0) {
        return codes;
    }
    int base = side * rows_a_look;
    if ((place & opens) != 0) {
        light = decoded(base + first_picture_piece, conversions.rows[base + 6].zw, codes);
    }
    vec3 own = by_matrix(base, light);
    return (place & encodes) == 0
               ? own
               : vec3(encoded(base, own.r), encoded(base, own.g), encoded(base, own.b));
}

/// What is shown of what the look gives.
vec3 shown_of_look(int place, int side, int tonemap_row, vec3 c) {
    bool is_picture = (place & gives_picture) != 0, is_read = (place & decodes) != 0;
    if (!is_read && (is_picture || (place & stands_before) == 0)) {
        return c;
    }
    int base = side * rows_a_look;
    if (is_read) {
        c = decoded(base + first_code_piece, conversions.rows[base + 6].xy, c);
    }
    vec3 light = by_matrix(base + 3, c);
    return is_picture ? srgb_encode(saturate(light)) : tonemap(tonemap_row, sanitise(light));
}
