// Draws a waveform or a parade from its counts, with lines and figures of the levels, and
// marks above and below columns that have clipped texels.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 16, local_size_y = 16) in;
#include "common/scope.glsl"
#include "common/scope_draw.glsl"
layout(constant_id = 0) const uint planes = 1u;
layout(constant_id = 1) const bool is_overlaid = false;

layout(binding = 0) readonly buffer Counts { uint counts[]; };
layout(binding = 1) writeonly uniform image2D target;

/// The mean of the counts over a texel's height, at least one level high.
float count_at(uint plane, uint column, int row) {
    float per_texel = float(levels) / float(push.plot.w);
    float centre = (float(push.plot.w - row) - 0.5) * per_texel;
    float reach = 0.5 * max(per_texel, 1.0);
    float low = max(centre - reach, 0.0), high = min(centre + reach, float(levels));
    uint from = (plane * push.columns + column) * levels;
    float sum = 0.0;
    for (uint level = uint(low); level < min(uint(ceil(high)), levels); ++level) {
        sum += float(counts[from + level]) *
               (min(high, float(level + 1u)) - max(low, float(level)));
    }
    return sum / max(high - low, 1e-6);
}

vec3 plane_color(uint plane) {
    if (planes == 1u) {
        return vec3(0.80, 0.97, 0.84);
    }
    return plane == 0u ? vec3(1.0, 0.30, 0.26) : plane == 1u ? vec3(0.30, 0.92, 0.36)
                                                             : vec3(0.36, 0.54, 1.0);
}

vec3 ground_color(ivec2 at) {
    vec3 color = ground;
    for (uint line = 0u; line < push.lines; ++line) {
        float level = line_code(line) + 0.5;
        float y = float(push.plot.w) * (1.0 - level / float(levels));
        color = mix(color, line_color, coverage(float(at.y) + 0.5 - y, 1.0));
    }
    return color;
}

bool is_clipped(uint plane, uint column, uint level) {
    return push.marks != 0u && counts[(plane * push.columns + column) * levels + level] > 0u;
}

/// Laid over `color`.
vec3 with_plane(vec3 color, ivec2 at, uint plane) {
    uint column = uint(at.x) * push.columns / uint(push.plot.z);
    if (at.y < mark_size() && is_clipped(plane, column, levels - 1u)) {
        return white_mark;
    }
    if (at.y >= push.plot.w - mark_size() && is_clipped(plane, column, 0u)) {
        return black_mark;
    }
    uint from = (column * push.width + push.columns - 1u) / push.columns;
    uint to = ((column + 1u) * push.width + push.columns - 1u) / push.columns;
    float texels = float(to - from) * float(push.height);
    float density = count_at(plane, column, at.y) * float(levels) / max(texels, 1.0);
    // Traces that lie over each other add up to white no sooner than one alone.
    return color + trace(plane_color(plane), density, float(levels)) * (is_overlaid ? 0.4 : 1.0);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    vec3 color = at.x < push.plot.x && labelled(at) ? label_color : surround;
    for (uint plane = 0u; plane < planes; ++plane) {
        ivec2 inside = at - push.plot.xy - ivec2(int(plane) * push.stride, 0);
        if (all(greaterThanEqual(inside, ivec2(0))) && all(lessThan(inside, push.plot.zw))) {
            bool is_first = plane == 0u || !is_overlaid;
            color = with_plane(is_first ? ground_color(inside) : color, inside, plane);
        }
    }
    imageStore(target, at, vec4(min(color, 1.0), 1.0));
}
