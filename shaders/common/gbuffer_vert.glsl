// Places an object's vertices in the picture. With HAS_DETAIL also what textures need.
#include "common/scene.glsl"
layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Objects { Object objects[]; };
layout(binding = 2) uniform Views { View view; };
layout(location = 0) out vec3 normal;
layout(location = 1) flat out uint material;
#ifdef HAS_DETAIL
#define DETAIL_BINDING 5
#include "common/detail.glsl"
layout(std430, binding = 3) readonly buffer VertexDetails { VertexDetail vertex_details[]; };
layout(location = 2) out vec4 uv;
layout(location = 3) out vec4 color;
layout(location = 4) out vec4 tangent;
#endif

void main() {
    Vertex vertex = vertices[gl_VertexIndex];
    Object object = objects[gl_InstanceIndex];
    normal = transform_normal(object, decode_octahedral(unpackSnorm2x16(vertex.normal)));
    material = object.material.x;
    gl_Position = view.clip * vec4(transform_point(object.model, vertex.position), 1.0);
#ifdef HAS_DETAIL
    VertexDetail detail = vertex_details[gl_VertexIndex];
    uv = vec4(detail.uv[0], detail.uv[1]);
    color = vertex_color(detail);
    tangent = tangent_of(object, detail.tangent, detail.side);
#endif
}
