// The colours of a heat map, and its scale.
#include "common/glyphs.glsl"
#include "common/sanitise.glsl"

/// Black, blue, magenta, orange, yellow, white over 0..1: brighter is more, in grey too.
vec3 heat(float share) {
    const vec3 stops[6] = vec3[6](vec3(0.0, 0.0, 0.02), vec3(0.13, 0.08, 0.46),
                                  vec3(0.60, 0.13, 0.46), vec3(0.93, 0.41, 0.20),
                                  vec3(0.99, 0.78, 0.24), vec3(1.0, 1.0, 0.92));
    float x = saturate(share) * 5.0;
    int i = min(int(x), 4);
    return mix(stops[i], stops[i + 1], x - float(i));
}

/// Draws the scale of a heat map into the lower left corner: a bar with the figures 0, 1/4, 1/2,
/// 3/4 and all of `scale`, which is divisible by 4.
vec3 with_scale(vec3 color, ivec2 at, ivec2 size, float scale) {
    int dot_size = max(size.y / 180, 1);
    ivec2 bar = ivec2(64, 5) * dot_size;
    ivec2 p = at - ivec2(8 * dot_size, size.y - 17 * dot_size);
    ivec2 panel_low = ivec2(-5, -4) * dot_size, panel_high = bar + ivec2(8, 11) * dot_size;
    if (any(lessThan(p, panel_low)) || any(greaterThanEqual(p, panel_high))) {
        return color;
    }
    if (all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, bar))) {
        return heat((float(p.x) + 0.5) / float(bar.x));
    }
    for (int i = 0; i <= 4; ++i) {
        int number = int(scale) * i / 4;
        int width = (number < 10 ? 1 : 2) * glyph_step * dot_size;
        ivec2 corner = ivec2(bar.x * i / 4 + (width + dot_size) / 2, bar.y + 2 * dot_size);
        if (in_label(p - corner, uint(number), dot_size)) {
            return vec3(1.0);
        }
    }
    return vec3(0.04);
}
