// White; with an alpha of 0 one that is added to what is there.
#version 460
layout(constant_id = 0) const uint alpha = 1u;
layout(location = 0) out vec4 out_light;

void main() {
    out_light = vec4(vec3(1.0), float(alpha));
}
