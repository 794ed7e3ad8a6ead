// The facets themselves, in their materials' colours, under a light at the eye.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
layout(binding = 2) uniform Views { View view; };
layout(std430, binding = 3) readonly buffer Materials { Material materials[]; };
layout(push_constant) uniform Push { uint width, height; };
layout(location = 1) flat in uint material;
layout(location = 0) out vec4 out_light;
#include "common/seen.glsl"

void main() {
    vec3 ray = ray_at(view, gl_FragCoord.xy, vec2(width, height));
    vec3 position = ray * z_of(view, gl_FragCoord.z);
    vec3 face = unit_or_up(cross(dFdx(position), dFdy(position)));
    float facing = abs(dot(face, normalize(ray)));
    out_light = vec4(materials[material].albedo_roughness.rgb * (0.1 + 0.9 * facing), 1.0);
}
