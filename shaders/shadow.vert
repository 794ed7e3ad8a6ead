// Places an object's vertices in a light's shadow map.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Objects { Object objects[]; };
layout(std430, binding = 2) readonly buffer Lights { Light lights[]; };
layout(push_constant) uniform Push { uint light; };

void main() {
    Object object = objects[gl_InstanceIndex];
    vec3 position = transform_point(object, vertices[gl_VertexIndex].position);
    gl_Position = lights[light].clip * vec4(position, 1.0);
}
