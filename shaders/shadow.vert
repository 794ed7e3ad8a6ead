// Places a caster's vertices in a light's shadow map.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Casters { Caster casters[]; };
layout(push_constant) uniform Push { mat4 clip; };

void main() {
    vec3 position =
        transform_point(casters[gl_InstanceIndex].model, vertices[gl_VertexIndex].position);
    gl_Position = clip * vec4(position, 1.0);
}
