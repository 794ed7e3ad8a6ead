// Counts the colour differences of a picture. Its 65536 counts do not fit into shared memory, but
// most pictures are near neutral: a group counts the middle there, and the rest in the buffer. A
// thread adds a run of equal colours at once.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scope.glsl"
#include "common/scope_area.glsl"
layout(local_size_x = 256) in;

layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) buffer Counts { uint counts[]; };

const uint side = 64u; // of the middle
const uint corner = 128u - side / 2u;
shared uint middle[side * side];

void add(uvec2 chroma, uint count) {
    uvec2 place = chroma - corner; // wraps to beyond the side
    if (all(lessThan(place, uvec2(side)))) {
        atomicAdd(middle[place.y * side + place.x], count);
    } else {
        atomicAdd(counts[chroma.y * levels + chroma.x], count);
    }
}

void main() {
    const uint threads = gl_WorkGroupSize.x;
    for (uint i = gl_LocalInvocationIndex; i < side * side; i += threads) {
        middle[i] = 0u;
    }
    barrier();

    uint texels = push.total * push.height;
    uvec2 held = uvec2(0u);
    uint run = 0u;
    for (uint i = gl_GlobalInvocationID.x; i < texels; i += threads * gl_NumWorkGroups.x) {
        ivec2 at = texel_of(i % push.total, i / push.total);
        if (!is_counted(at)) {
            continue;
        }
        uvec2 chroma = chroma_of(codes_of(texelFetch(picture, at, 0).rgb));
        if (chroma != held) {
            if (run > 0u) {
                add(held, run);
            }
            held = chroma;
            run = 0u;
        }
        ++run;
    }
    if (run > 0u) {
        add(held, run);
    }
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < side * side; i += threads) {
        if (middle[i] > 0u) {
            atomicAdd(counts[(corner + i / side) * levels + corner + i % side], middle[i]);
        }
    }
}
