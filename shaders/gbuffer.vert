// Places an object's vertices in the picture.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Objects { Object objects[]; };
layout(binding = 2) uniform Views { View view; };
layout(location = 0) out vec3 normal;
layout(location = 1) flat out uint material;

void main() {
    Vertex vertex = vertices[gl_VertexIndex];
    Object object = objects[gl_InstanceIndex];
    normal = transform_normal(object, decode_octahedral(unpackSnorm2x16(vertex.normal)));
    material = object.material.x;
    gl_Position = view.clip * vec4(transform_point(object.model, vertex.position), 1.0);
}
