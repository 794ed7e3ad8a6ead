// A debug view: an image in the size of the picture that shows it, by its nearest texels. Who
// includes this defines shown(); with VIEW_UNSIGNED the image is of integers.
#include "common/sanitise.glsl"
layout(local_size_x = 16, local_size_y = 16) in;
#ifdef VIEW_UNSIGNED
#define VIEWED usampler2D
#define VIEWED_TEXEL uvec4
#else
#define VIEWED sampler2D
#define VIEWED_TEXEL vec4
#endif
layout(binding = 0) uniform VIEWED source;
layout(binding = 1) writeonly uniform image2D target;
layout(constant_id = 0) const bool as_numbers = false;
layout(push_constant) uniform Push {
    float near_plane; // of the camera, in metres
} view_push;

/// The colour that stands for a texel, as display codes; the texel's own numbers where these are
/// asked for.
vec3 shown(VIEWED_TEXEL texel);

ivec2 shown_at; ///< the texel's place

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    shown_at = at * textureSize(source, 0) / size;
    vec3 color = shown(texelFetch(source, shown_at, 0));
    imageStore(target, at, vec4(as_numbers ? color : saturate(color), 1.0));
}
