// The blocks of preview/scene/scene_data.h.
#ifndef SCENE_GLSL
#define SCENE_GLSL

struct Vertex {
    vec3 position;
    uint normal;
};

struct Object {
    vec4 model[3];
    vec4 normal[3];
    uvec4 material;
};

struct Caster {
    vec4 model[3];
};

struct Material {
    vec4 albedo_roughness;
    vec4 emission_metalness;
};

struct Light {
    vec4 position_layer;
    vec4 intensity_texel;
    vec4 axis_scale; // of a spot's cone
    vec4 range; // x: of the cone; y, z: of the shadow maps' depths; w: 1 of a sun
    // Of a shadow map. up_thickness.w: of an area; forward.w: 1 / reach^2 of a light that ends, else 0.
    vec4 right_tangent, up_thickness, forward;
    vec4 extent_shape; // of a sun: where its shadow map is looked at from
    uvec4 faces; // x
};

struct View {
    mat4 clip;
    vec4 position_near;
    vec4 forward, right, up;
};

/// By the rows of an affine transform.
vec3 transform_point(vec4 rows[3], vec3 p) {
    vec4 q = vec4(p, 1.0);
    return vec3(dot(rows[0], q), dot(rows[1], q), dot(rows[2], q));
}

vec3 transform_normal(Object object, vec3 n) {
    vec4 q = vec4(n, 0.0);
    return vec3(dot(object.normal[0], q), dot(object.normal[1], q), dot(object.normal[2], q));
}

/// Unit length; up for a vector without a direction.
vec3 unit_or_up(vec3 v) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : vec3(0.0, 1.0, 0.0);
}

// Octahedral unit vectors (Cigolle et al. 2014), 16 bits a coordinate.
vec3 decode_octahedral(vec2 e) {
    vec3 v = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    if (v.z < 0.0) {
        v.xy = (1.0 - abs(v.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(v.xy, vec2(0.0)));
    }
    return normalize(v);
}

vec2 encode_octahedral(vec3 v) {
    v /= abs(v.x) + abs(v.y) + abs(v.z);
    vec2 folded =
        (1.0 - abs(v.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(v.xy, vec2(0.0)));
    return v.z < 0.0 ? folded : v.xy;
}

/// A tangent of VertexDetail in the world, and its side: mirroring turns that round.
vec4 tangent_of(Object object, uint octahedral, float side) {
    if (side == 0.0) {
        return vec4(0.0);
    }
    vec4 q = vec4(decode_octahedral(unpackSnorm2x16(octahedral)), 0.0);
    mat3 columns = transpose(mat3(object.model[0].xyz, object.model[1].xyz, object.model[2].xyz));
    vec3 along = vec3(dot(object.model[0], q), dot(object.model[1], q), dot(object.model[2], q));
    return vec4(unit_or_up(along), determinant(columns) < 0.0 ? -side : side);
}

uvec2 to_bits(vec2 e) {
    return uvec2(clamp(e * 0.5 + 0.5, 0.0, 1.0) * 65534.0 + 0.5);
}

vec2 from_bits(uvec2 bits) {
    return vec2(bits) / 32767.0 - 1.0;
}

#endif
