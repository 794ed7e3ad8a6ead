// The strokes: each where it lies, along the curl of a noise that changes in smooth steps, in the
// colour that the picture has there. The curl of a scalar noise n is (dn/dy, -dn/dx): a flow without
// sources, whose lines close or go on. reference/paintbrush.cpp is its twin.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/hash.glsl"
#include "common/noise_slope.glsl"
#include "common/sanitise.glsl"
#include "common/strokes.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D flows;  // direction, then where in the cell
layout(binding = 2) writeonly uniform image2D colors; // and how much it weighs
layout(push_constant) uniform Push {
    float cell;      // in texels
    float frequency; // of the noise, in periods a cell
    float depth;     // in the noise: the moment
    float coherence;
    int side_width, columns; // of one side's picture and strokes
} push;

vec2 unit_or_along_x(vec2 v) {
    float squared = dot(v, v);
    return squared > 1e-12 ? v * inversesqrt(squared) : vec2(1.0, 0.0);
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(flows)))) {
        return;
    }
    ivec2 size = ivec2(push.side_width, textureSize(source, 0).y);
    int side = at.x / push.columns;
    ivec2 cell = ivec2(at.x - side * push.columns, at.y) - stroke_reach;
    uvec3 bits = pcg3d(uvec3(ivec3(cell, 1)));
    vec3 random = unit_of(bits);
    vec2 centre = 0.5 + stroke_jitter * (random.xy - 0.5);
    vec2 slope = perlin_with_slope(vec3((vec2(cell) + centre) * push.frequency, push.depth)).xy;
    vec2 along = unit_or_along_x(vec2(slope.y, -slope.x));
    float turn = 6.2831853 * random.z;
    along = unit_or_along_x(mix(vec2(cos(turn), sin(turn)), along, push.coherence));
    vec3 sum = vec3(0.0);
    for (int i = -1; i <= 1; ++i) {
        vec2 place = (vec2(cell) + centre + 0.3 * float(i) * along) * push.cell;
        ivec2 texel = clamp(ivec2(floor(place)), ivec2(0), size - 1);
        sum += saturate(texelFetch(source, texel + ivec2(side * push.side_width, 0), 0).rgb);
    }
    imageStore(flows, at, vec4(along, centre));
    // What lies higher counts so much more that it hides what it lies on.
    float height = float(pcg3d(bits).x >> 8u) / 16777216.0;
    imageStore(colors, at, vec4(sum / 3.0, exp2(14.0 * height)));
}
