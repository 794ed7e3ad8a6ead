// Draws a vectorscope from its counts: each place in its own hue, the circle of the largest
// differences, boxes at the 75 % bars and small ones at the full colours, and the skin line.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 16, local_size_y = 16) in;
#include "common/scope.glsl"
#include "common/scope_draw.glsl"

layout(binding = 0) readonly buffer Counts { uint counts[]; };
layout(binding = 1) writeonly uniform image2D target;

const float turn = 6.28318530717959;
const float skin_angle = 123.0 / 360.0 * turn;
const vec3 skin_color = vec3(0.86, 0.58, 0.40);

// Red, magenta, blue, cyan, green, yellow.
const vec3 bars[6] = vec3[6](vec3(1, 0, 0), vec3(1, 0, 1), vec3(0, 0, 1), vec3(0, 1, 1),
                             vec3(0, 1, 0), vec3(1, 1, 0));

/// Texels from one end of Cb or Cr to the other: the boxes at full colours have room beside them.
float scale_of_plot() {
    return float(push.plot.z) / 1.06;
}

/// Cb and Cr within -1/2..1/2.
vec2 differences_of(vec3 c) {
    float luma = dot(c, vec3(0.2126, 0.7152, 0.0722));
    return vec2((c.b - luma) / 1.8556, (c.r - luma) / 1.5748);
}

vec3 color_of(vec2 d) {
    const float luma = 0.6;
    return clamp(vec3(luma + 1.5748 * d.y, luma - 0.187324 * d.x - 0.468124 * d.y,
                      luma + 1.8556 * d.x),
                 0.0, 1.0);
}

/// The counts about a place, by a tent of a texel's width and at least a bin's.
float count_at(vec2 d) {
    vec2 bin = d * 255.0 + 128.0;
    float reach = max(255.0 / scale_of_plot(), 1.0);
    ivec2 from = max(ivec2(ceil(bin - reach)), 0), to = min(ivec2(floor(bin + reach)), 255);
    float sum = 0.0, weights = 0.0;
    for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
            vec2 near = 1.0 - abs(vec2(x, y) - bin) / reach;
            sum += float(counts[y * int(levels) + x]) * near.x * near.y;
            weights += near.x * near.y;
        }
    }
    return sum / max(weights, 1e-6);
}

float box(vec2 from_middle, float half_side) {
    vec2 away = abs(from_middle);
    return coverage(max(away.x, away.y) - half_side, 1.0);
}

vec3 graticule(vec2 d, float scale) {
    vec3 color = ground;
    float radius = length(d) * scale, rim = 0.5 * scale;
    vec2 p = d * scale;
    color = mix(color, line_color, 0.6 * max(coverage(p.x, 1.0), coverage(p.y, 1.0)) *
                                       float(radius < rim));
    // A tick every ten degrees.
    float angle = atan(d.y, d.x);
    float tick = (angle - round(angle / turn * 36.0) / 36.0 * turn) * radius;
    bool in_ticks = radius < rim && radius > rim * 0.965;
    color = mix(color, line_color, coverage(tick, 1.0) * float(in_ticks));
    color = mix(color, line_color, coverage(radius - rim, 1.4));
    vec2 skin = vec2(cos(skin_angle), sin(skin_angle));
    float beside = p.x * skin.y - p.y * skin.x;
    color = mix(color, skin_color,
                0.8 * coverage(beside, 1.2) * float(dot(p, skin) > 0.0 && radius < rim));
    for (int i = 0; i < 6; ++i) {
        vec2 full = differences_of(bars[i]);
        color = mix(color, color_of(full), 0.9 * box(p - 0.75 * full * scale, 0.02 * scale));
        color = mix(color, color_of(full), 0.45 * box(p - full * scale, 0.008 * scale));
    }
    return color;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    ivec2 inside = at - push.plot.xy;
    vec3 color = surround;
    if (all(greaterThanEqual(inside, ivec2(0))) && all(lessThan(inside, push.plot.zw))) {
        float side = float(push.plot.z), scale = scale_of_plot();
        vec2 d = vec2(float(inside.x) + 0.5 - 0.5 * side, 0.5 * side - float(inside.y) - 0.5) /
                 scale;
        color = labelled(at) ? label_color : graticule(d, scale);
        float bins = float(levels * levels);
        float texels = float(push.width) * float(push.height);
        color += trace(color_of(d), count_at(d) * bins / max(texels, 1.0), bins);
    }
    imageStore(target, at, vec4(min(color, 1.0), 1.0));
}
