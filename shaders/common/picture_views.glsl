// Ways to look at a finished picture: the functions that rows of preview/finish/picture_views.cpp
// name, each for one texel. The build writes the choice among the rows, their legends' colours and
// the bands of levels (rows/picture_views.glsl). preview/reference/picture_views.cpp is the twin.
#include "common/luma.glsl"
#include "common/sanitise.glsl"

/// A texel and what there is to know of it.
struct Viewed {
    vec3 color;  // codes of the finished picture, not clamped
    vec3 before; // those before the looks, where the row reads them
    ivec2 at;
    int unit;    // texels of a dot of the legend
    float level; // of luma, from which on it is high
};

const float half_code = 0.5 / 255.0;

vec3 grey_of(float code) {
    return vec3(saturate(code));
}

vec3 view_false_color(Viewed v) {
    float luma = saturate(luma_of(saturate(v.color)));
    for (int i = 0; i < level_count; ++i) {
        if (luma < level_ends[i]) {
            return level_is_marked[i] ? level_colors[i] : vec3(luma);
        }
    }
    return level_colors[level_count - 1];
}

vec3 view_zebra(Viewed v) {
    vec3 color = saturate(v.color);
    bool is_high = luma_of(color) >= v.level;
    int stripe = (v.at.x + v.at.y) / (3 * v.unit) & 1;
    return is_high ? vec3(float(stripe)) : color;
}

bool is_at_top(vec3 c) {
    return any(greaterThanEqual(c, vec3(1.0 - half_code)));
}

bool is_at_bottom(vec3 c) {
    return any(lessThanEqual(c, vec3(half_code)));
}

vec3 view_clipping(Viewed v) {
    if (is_at_top(v.color)) {
        return is_at_top(v.before) ? clipping_colors[0] : clipping_colors[1];
    }
    if (is_at_bottom(v.color)) {
        return is_at_bottom(v.before) ? clipping_colors[2] : clipping_colors[3];
    }
    return v.color;
}

bool is_outside(vec3 c) {
    return any(greaterThan(c, vec3(1.0 + half_code))) || any(lessThan(c, vec3(-half_code)));
}

vec3 view_gamut(Viewed v) {
    if (is_outside(v.color)) {
        return is_outside(v.before) ? gamut_colors[0] : gamut_colors[1];
    }
    return vec3(0.5 * saturate(luma_of(saturate(v.color))));
}

vec3 view_red(Viewed v) {
    return grey_of(v.color.r);
}

vec3 view_green(Viewed v) {
    return grey_of(v.color.g);
}

vec3 view_blue(Viewed v) {
    return grey_of(v.color.b);
}

vec3 view_luma(Viewed v) {
    return grey_of(luma_of(saturate(v.color)));
}

vec3 view_saturation(Viewed v) {
    vec3 c = saturate(v.color);
    float most = max(c.r, max(c.g, c.b)), least = min(c.r, min(c.g, c.b));
    return vec3(most > 0.0 ? (most - least) / most : 0.0);
}
