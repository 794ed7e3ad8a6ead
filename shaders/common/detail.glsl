// What a surface is at a point of it: a material's numbers times its textures and the colours of
// vertices. Who includes this defines DETAIL_BINDING, the first of three bindings.
// preview/reference/surface.h is the same in double.
#ifndef DETAIL_GLSL
#define DETAIL_GLSL
#define TEXTURE_BINDING (DETAIL_BINDING + 1)
#include "common/texture.glsl"

struct VertexDetail {
    vec2 uv[2];
    uvec2 color; // four numbers of 16 bits
    uint tangent; // octahedral
    float side;
};

struct TextureUse {
    vec3 u_row;
    uint number;
    vec3 v_row;
    uint uv_set;
};

/// Places in MaterialDetail.uses.
const int base_use = 0, surface_use = 1, normal_use = 2, occlusion_use = 3, emission_use = 4;

struct MaterialDetail {
    TextureUse uses[5];
    float normal_scale;
    float occlusion_strength;
    float coverage;
    float least_coverage;
    uvec4 is_unlit;
};
layout(std430, binding = DETAIL_BINDING) readonly buffer MaterialDetails {
    MaterialDetail material_details[];
};

/// Texture coordinates and their changes to the pixels beside.
struct Footprint {
    vec4 uv, dx, dy; // both sets
};

vec4 vertex_color(VertexDetail vertex) {
    return vec4(unpackUnorm2x16(vertex.color.x), unpackUnorm2x16(vertex.color.y));
}

vec4 read_texture(TextureUse use, Footprint at) {
    bool second = use.uv_set != 0u;
    vec2 uv = second ? at.uv.zw : at.uv.xy;
    vec2 dx = second ? at.dx.zw : at.dx.xy;
    vec2 dy = second ? at.dy.zw : at.dy.xy;
    mat2 turn = mat2(use.u_row.x, use.v_row.x, use.u_row.y, use.v_row.y);
    return texture_at(use.number, turn * uv + vec2(use.u_row.z, use.v_row.z), turn * dx, turn * dy);
}

/// Albedo times the colour, and how far the surface covers what lies behind.
vec4 base_of(vec3 albedo, uint material, Footprint at, vec4 color) {
    vec4 base = vec4(albedo, material_details[material].coverage) * color;
    return material_details[material].uses[base_use].number == no_texture
               ? base
               : base * read_texture(material_details[material].uses[base_use], at);
}

#endif
