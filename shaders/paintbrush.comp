// Strokes of a brush: ellipses whose edges fray by a noise, each over those that lie lower. A texel
// takes the strokes of the five by five cells about its own, which its group keeps in shared
// memory. reference/paintbrush.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/hash.glsl"
#include "common/sanitise.glsl"
#include "common/strokes.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) uniform sampler2D flows;
layout(binding = 2) uniform sampler2D colors;
layout(binding = 3) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    float strength;
    float cell;        // in texels, at least 2
    float half_length; // of a stroke, in cells; at most 1.5
    int side_width, columns;
} push;

const int side_cells = 16 / 2 + 2 + 2 * stroke_reach; // that a group's 16 texels meet at most
shared vec4 kept_flows[side_cells * side_cells], kept_colors[side_cells * side_cells];

/// Even noise between the points of a grid of four to a cell, -1..1.
float fray_at(vec2 place) {
    vec2 low = floor(4.0 * place);
    vec2 f = 4.0 * place - low;
    vec4 corners;
    for (int i = 0; i < 4; ++i) {
        ivec2 point = ivec2(low) + ivec2(i & 1, i >> 1);
        corners[i] = unit_of(pcg3d(uvec3(ivec3(point, 2)))).x;
    }
    return 2.0 * mix(mix(corners.x, corners.y, f.x), mix(corners.z, corners.w, f.x), f.y) - 1.0;
}

void main() {
    // Groups do not reach over the border between two sides.
    int groups_a_side = (push.side_width + 15) / 16;
    int side = int(gl_WorkGroupID.x) / groups_a_side;
    ivec2 first = ivec2(int(gl_WorkGroupID.x) % groups_a_side, gl_WorkGroupID.y) * 16;
    ivec2 low = ivec2(floor((vec2(first) + 0.5) / push.cell));
    ivec2 strokes = ivec2(push.columns, textureSize(flows, 0).y);
    ivec2 met = ivec2(floor((vec2(first) + 15.5) / push.cell)) - low + 1 + 2 * stroke_reach;
    for (int i = int(gl_LocalInvocationIndex); i < met.x * met.y; i += 256) {
        ivec2 place = ivec2(i % met.x, i / met.x);
        ivec2 stroke = min(low + place, strokes - 1);
        stroke.x += side * push.columns;
        kept_flows[place.y * side_cells + place.x] = texelFetch(flows, stroke, 0);
        kept_colors[place.y * side_cells + place.x] = texelFetch(colors, stroke, 0);
    }
    barrier();
    ivec2 own = first + ivec2(gl_LocalInvocationID.xy);
    if (own.x >= push.side_width || own.y >= imageSize(target).y) {
        return;
    }
    vec2 place = (vec2(own) + 0.5) / push.cell;
    ivec2 cell = ivec2(floor(place));
    float fray = 0.25 * fray_at(place);
    vec2 scale = 1.0 / vec2(push.half_length, stroke_half_width);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int y = -stroke_reach; y <= stroke_reach; ++y) {
        for (int x = -stroke_reach; x <= stroke_reach; ++x) {
            ivec2 other = cell + ivec2(x, y);
            ivec2 kept = other - low + stroke_reach;
            vec4 flow = kept_flows[kept.y * side_cells + kept.x];
            vec2 from = place - vec2(other) - flow.zw;
            vec2 on_stroke = vec2(dot(from, flow.xy), from.y * flow.x - from.x * flow.y) * scale;
            float distance_squared = dot(on_stroke, on_stroke);
            if (distance_squared >= (1.0 + fray) * (1.0 + fray)) {
                continue;
            }
            vec4 color = kept_colors[kept.y * side_cells + kept.x];
            float inside = min((1.0 - sqrt(distance_squared) + fray) * 3.0, 1.0);
            float weight = inside * inside * (3.0 - 2.0 * inside) * color.a;
            sum += weight * color.rgb;
            weights += weight;
        }
    }
    ivec2 at = own + ivec2(side * push.side_width, 0);
    vec3 own_color = saturate(texelFetch(source, at, 0).rgb);
    vec3 painted = weights > 1e-3 ? sum / weights : own_color;
    imageStore(target, at, vec4(mix(own_color, painted, push.strength), 1.0));
}
