// What the drawings of all scopes share: their layout, their figures, their colours and how counts
// become light.
#include "common/glyphs.glsl"

layout(push_constant) uniform Push {
    ivec4 plot; // of the first: x, y, width, height
    int stride; // to the next
    int dot_size;
    uint columns; // of counts
    uint width, height; // of the picture that was counted
    uint logarithmic;
    uint labels;
    uint lines; // of levels
    uint marks; // whether what is clipped has marks: levels are the codes as they are shown
    float gain; // of counts
} push;

layout(std430, binding = 2) readonly buffer Labels {
    // x, y of the upper left corner, five glyphs in six bits each from the first, how many; then of
    // each line its code, a float of 0..255.
    ivec4 labels[];
};

/// Whether a texel is part of a figure.
bool labelled(ivec2 at) {
    for (uint i = 0u; i < push.labels; ++i) {
        ivec2 p = at - labels[i].xy;
        int step = glyph_step * push.dot_size, place = p.x / step;
        if (p.x >= 0 && place < labels[i].w &&
            in_glyph(p - ivec2(place * step, 0), uint(labels[i].z) >> 6 * place & 63u,
                     push.dot_size)) {
            return true;
        }
    }
    return false;
}

const vec3 surround = vec3(0.075, 0.075, 0.085), ground = vec3(0.02, 0.02, 0.025);
const vec3 line_color = vec3(0.30, 0.25, 0.16), label_color = vec3(0.72, 0.64, 0.46);

/// What a place adds whose counts lie `density` times denser than if they were spread evenly over
/// all `bins`: like a beam's, its light whitens where it is brightest. In proportion, a sixteenth
/// of all in one waveform level is full light already.
vec3 trace(vec3 color, float density, float bins) {
    density *= push.gain;
    float light = push.logarithmic != 0u
                      ? pow(log2(1.0 + 24.0 * density) / log2(1.0 + 24.0 * bins), 0.72)
                      : density / sqrt(bins);
    light = min(light, 1.0);
    return color * light + 0.55 * light * light * light;
}

/// The code at which a line stands.
float line_code(uint line) {
    return intBitsToFloat(labels[push.labels + line].x);
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
