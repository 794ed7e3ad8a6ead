// Many steps of a bloom plan over small images in one group, which keeps them in shared memory
// (preview/finish/bloom_dispatches.h). Each step does what bloom_filter.comp or bloom_gaussian.comp
// does. A group reads all that a step needs before it writes: its target may lie upon its source.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/sanitise.glsl"
layout(local_size_x = 640) in; // more have too few registers each

// Images: width, height, and where they begin in shared memory; below 0, the image outside.
struct Step {
    ivec4 source, own, target;
    ivec4 rows; // the first, how many; the axis: 0 both, 1 x, 2 y; and along it the radius
    vec4 how;   // scale of source and of own, weight of own
};

layout(binding = 0) uniform sampler2D source;
// Rows of a step over both axes are its taps: offset and weight. Along one a thread makes four
// neighbours: each row is what a texel weighs in them, from the radius before the first on. Steps
// have whole fours of rows, which are read at once.
layout(std430, binding = 1) readonly buffer Plan {
    Step steps[16];
    vec4 rows[224];
} plan;
layout(binding = 2) writeonly uniform image2D target;
layout(push_constant) uniform Push { int step_count; };

const int threads = 640, texels_each = 4, rows_at_once = 4;
shared uvec2 texels[3456]; // as half floats
shared Step steps[16];
shared vec4 rows[224];

vec3 texel_at(int place) {
    uvec2 texel = texels[place];
    return vec3(unpackHalf2x16(texel.x), unpackHalf2x16(texel.y).x);
}

/// Bilinear, at a place in texels of the image outside.
vec3 fetch_outside(vec2 at) {
    return textureLod(source, at / vec2(textureSize(source, 0)), 0.0).rgb;
}

/// The same of an image in shared memory.
vec3 fetch(ivec4 image, vec2 at) {
    vec2 low = floor(at - 0.5), part = at - 0.5 - low;
    ivec2 last = image.xy - 1;
    ivec2 a = clamp(ivec2(low), ivec2(0), last), b = clamp(ivec2(low) + 1, ivec2(0), last);
    int above = image.z + a.y * image.x, below = image.z + b.y * image.x;
    return mix(mix(texel_at(above + a.x), texel_at(above + b.x), part.x),
               mix(texel_at(below + a.x), texel_at(below + b.x), part.x), part.y);
}

/// The first of the texels that a thread makes; the others are `next` from each other.
ivec2 first_texel(Step step, int thread, out ivec2 next) {
    ivec2 size = step.target.xy;
    if (step.rows.z == 1) {
        int each = (size.x + texels_each - 1) / texels_each;
        next = ivec2(1, 0);
        return ivec2(thread % each * texels_each, thread / each);
    }
    // Over both axes as many threads as there are take part.
    next = ivec2(0, step.rows.z == 2 ? 1 : threads / size.x);
    return ivec2(thread % size.x, thread / size.x * (step.rows.z == 2 ? texels_each : 1));
}

// Many loads at once, and so no choice between the image outside and shared memory around each.

void filter_line(Step step, ivec2 first, ivec2 next, inout vec3 sums[texels_each]) {
    ivec4 image = step.source;
    bool along_x = next.x > 0, is_outside = image.z < 0;
    int pitch = along_x ? 1 : image.x, last = (along_x ? image.x : image.y) - 1;
    int start = (along_x ? first.x : first.y) - step.rows.w;
    ivec2 line = first * next.yx;
    int base = image.z + line.y * image.x + line.x;
    for (int j = 0; j < step.rows.y; j += rows_at_once) {
        vec3 light[rows_at_once];
        if (is_outside) {
            for (int l = 0; l < rows_at_once; ++l) {
                int i = clamp(start + j + l, 0, last);
                light[l] = texelFetch(source, line + i * next, 0).rgb;
            }
        } else {
            for (int l = 0; l < rows_at_once; ++l) {
                light[l] = texel_at(base + clamp(start + j + l, 0, last) * pitch);
            }
        }
        for (int l = 0; l < rows_at_once; ++l) {
            vec4 weight = rows[step.rows.x + j + l];
            for (int k = 0; k < texels_each; ++k) {
                sums[k] += light[l] * weight[k];
            }
        }
    }
}

vec3 filtered(Step step, ivec2 at) {
    vec2 centre = (vec2(at) + 0.5) * step.how.x;
    bool is_outside = step.source.z < 0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < step.rows.y; i += rows_at_once) {
        int row = step.rows.x + i;
        vec3 light[rows_at_once];
        if (is_outside) {
            for (int l = 0; l < rows_at_once; ++l) {
                light[l] = fetch_outside(centre + rows[row + l].xy);
            }
        } else {
            for (int l = 0; l < rows_at_once; ++l) {
                light[l] = fetch(step.source, centre + rows[row + l].xy);
            }
        }
        for (int l = 0; l < rows_at_once; ++l) {
            sum += light[l] * rows[row + l].z;
        }
    }
    return sum;
}

void main() {
    int thread = int(gl_LocalInvocationIndex);
    if (thread < plan.rows.length()) {
        rows[thread] = plan.rows[thread];
    }
    if (thread < step_count) {
        steps[thread] = plan.steps[thread];
    }
    barrier();
    for (int s = 0; s < step_count; ++s) {
        Step step = steps[s];
        vec3 sums[texels_each];
        for (int k = 0; k < texels_each; ++k) {
            sums[k] = vec3(0.0);
        }
        ivec2 next, first = first_texel(step, thread, next), size = step.target.xy;
        bool is_busy = all(lessThan(first, size));
        if (is_busy && step.rows.z != 0) {
            filter_line(step, first, next, sums);
        } else if (is_busy) {
            sums[0] = filtered(step, first);
            if (next.y < size.y) {
                for (int k = 1; k < texels_each; ++k) {
                    sums[k] = filtered(step, min(first + k * next, size - 1));
                }
            }
        }
        if (is_busy && step.how.z > 0.0) {
            for (int k = 0; k < texels_each; ++k) {
                vec2 at = (vec2(first + k * next) + 0.5) * step.how.y;
                sums[k] += (step.own.z < 0 ? fetch_outside(at) : fetch(step.own, at)) * step.how.z;
            }
        }
        barrier();
        for (int k = 0; k < texels_each; ++k) {
            ivec2 at = first + k * next;
            if (any(greaterThanEqual(at, size))) {
                continue;
            }
            vec3 light = round_to_half(min(sums[k], half_max));
            if (step.target.z < 0) {
                imageStore(target, at, vec4(light, 1.0));
            } else {
                texels[step.target.z + at.y * size.x + at.x] =
                    uvec2(packHalf2x16(light.rg), packHalf2x16(vec2(light.b, 0.0)));
            }
        }
        barrier();
    }
}
