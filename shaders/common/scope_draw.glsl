// What the drawings of all scopes share: their layout, their colours and how counts become light.
#include "common/glyphs.glsl"

layout(push_constant) uniform Push {
    ivec4 plot; // of the first: x, y, width, height
    int stride; // to the next
    int dot_size;
    uint columns; // of counts
    uint width, height; // of the picture that was counted
    uint logarithmic;
} push;

const vec3 surround = vec3(0.075, 0.075, 0.085), ground = vec3(0.02, 0.02, 0.025);
const vec3 line_color = vec3(0.30, 0.25, 0.16), label_color = vec3(0.72, 0.64, 0.46);

/// What a place adds whose counts lie `density` times denser than if they were spread evenly over
/// all `bins`: like a beam's, its light whitens where it is brightest. In proportion, a sixteenth
/// of all in one waveform level is full light already.
vec3 trace(vec3 color, float density, float bins) {
    float light = push.logarithmic != 0u
                      ? pow(log2(1.0 + 24.0 * density) / log2(1.0 + 24.0 * bins), 0.72)
                      : min(density / sqrt(bins), 1.0);
    return color * light + 0.55 * light * light * light;
}

/// Marks what is clipped: at black, and at white.
const vec3 black_mark = vec3(0.16, 0.42, 1.0), white_mark = vec3(1.0, 0.22, 0.16);
int mark_size() {
    return 2 * push.dot_size;
}

/// How much of a texel lies on a line of that width whose middle is `distance` away.
float coverage(float distance, float width) {
    return clamp(0.5 + 0.5 * width - abs(distance), 0.0, 1.0);
}
