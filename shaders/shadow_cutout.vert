// As shadow.vert, for scenes with cut-outs.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common/scene.glsl"
#define DETAIL_BINDING 4
#include "common/detail.glsl"
layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Casters { Caster casters[]; };
layout(std430, binding = 2) readonly buffer CasterMaterials { uint caster_materials[]; };
layout(std430, binding = 3) readonly buffer VertexDetails { VertexDetail vertex_details[]; };
layout(push_constant) uniform Push { mat4 clip; };
layout(location = 0) flat out uint material;
layout(location = 1) out vec4 uv;
layout(location = 2) out vec4 color;

void main() {
    VertexDetail detail = vertex_details[gl_VertexIndex];
    material = caster_materials[gl_InstanceIndex];
    uv = vec4(detail.uv[0], detail.uv[1]);
    color = vertex_color(detail);
    vec3 position =
        transform_point(casters[gl_InstanceIndex].model, vertices[gl_VertexIndex].position);
    gl_Position = clip * vec4(position, 1.0);
}
