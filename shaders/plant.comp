// A copy with one texel of another value; preview/passes/plant.h says what for.
#version 460
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1) writeonly uniform image2D target;
layout(push_constant) uniform Push {
    ivec2 place;
    float value;
};

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) {
        return;
    }
    vec4 texel = texelFetch(source, at, 0);
    imageStore(target, at, at == place ? vec4(vec3(value), texel.a) : texel);
}
