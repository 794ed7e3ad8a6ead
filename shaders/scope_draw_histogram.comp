// Draws a histogram from its counts: red, green and blue as lights that add up, luma as a line over
// them. Its height is the largest count but for the outermost codes, where clipped values pile up
// and have marks. Lines and figures tell the levels.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 16, local_size_y = 16) in;
#include "common/scope.glsl"
#include "common/scope_draw.glsl"

layout(binding = 0) readonly buffer Counts { uint counts[]; };
layout(binding = 1) writeonly uniform image2D target;

shared uint most;

float share(float count) {
    count *= push.gain;
    if (push.logarithmic != 0u) {
        return log2(1.0 + count) / log2(1.0 + float(most));
    }
    return count / float(most);
}

/// Of the mean over a texel's width, at least one code, in texels.
float height_at(uint plane, float x) {
    float per_texel = float(levels) / float(push.plot.z);
    float reach = 0.5 * max(per_texel, 1.0);
    float low = clamp(x * per_texel - reach, 0.0, float(levels));
    float high = clamp(x * per_texel + reach, 0.0, float(levels));
    float sum = 0.0;
    for (uint level = uint(low); level < min(uint(ceil(high)), levels); ++level) {
        sum += float(counts[plane * levels + level]) *
               (min(high, float(level + 1u)) - max(low, float(level)));
    }
    return share(sum / max(high - low, 1e-6)) * float(push.plot.w);
}

vec3 plot_color(ivec2 at) {
    vec3 color = ground;
    for (uint plane = 0u; plane < 3u && at.y < 3 * mark_size() && push.marks != 0u; ++plane) {
        if (at.x < mark_size() && counts[plane * levels] > 0u) {
            return black_mark;
        }
        if (at.x >= push.plot.z - mark_size() && counts[plane * levels + levels - 1u] > 0u) {
            return white_mark;
        }
    }
    for (uint line = 0u; line < push.lines; ++line) {
        float x = float(push.plot.z) * (line_code(line) + 0.5) / float(levels);
        color = mix(color, line_color, coverage(float(at.x) + 0.5 - x, 1.0));
    }
    float x = float(at.x), y = float(push.plot.w - at.y) - 0.5;
    vec3 fill = vec3(0.0);
    for (uint plane = 0u; plane < 3u; ++plane) {
        float left = height_at(plane, x), right = height_at(plane, x + 1.0);
        float middle = height_at(plane, x + 0.5);
        float edge = clamp(max(left, right) + 0.7 - y, 0.0, 1.0) *
                     clamp(y - min(left, right) + 0.7, 0.0, 1.0);
        fill[plane] = 0.42 * clamp(middle - y + 0.5, 0.0, 1.0) + 0.45 * edge;
    }
    color += fill;
    float left = height_at(3u, x), right = height_at(3u, x + 1.0);
    float line = clamp(max(left, right) + 0.8 - y, 0.0, 1.0) *
                 clamp(y - min(left, right) + 0.8, 0.0, 1.0);
    return mix(color, vec3(0.92), 0.85 * line);
}

void main() {
    const uint threads = gl_WorkGroupSize.x * gl_WorkGroupSize.y;
    if (gl_LocalInvocationIndex == 0u) {
        most = 1u;
    }
    barrier();
    uint own = 0u;
    for (uint i = gl_LocalInvocationIndex; i < 4u * levels; i += threads) {
        if (i % levels != 0u && i % levels != levels - 1u) {
            own = max(own, counts[i]);
        }
    }
    atomicMax(most, own);
    barrier();

    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    ivec2 inside = at - push.plot.xy;
    bool in_plot = all(greaterThanEqual(inside, ivec2(0))) && all(lessThan(inside, push.plot.zw));
    vec3 color = in_plot ? plot_color(inside) : labelled(at) ? label_color : surround;
    imageStore(target, at, vec4(min(color, 1.0), 1.0));
}
