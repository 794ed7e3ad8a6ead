// Lets light through where a material is cut out.
#version 460
#extension GL_GOOGLE_include_directive : require
#define DETAIL_BINDING 4
#include "common/detail.glsl"
layout(location = 0) flat in uint material;
layout(location = 1) in vec4 uv;
layout(location = 2) in vec4 color;

void main() {
    Footprint at = Footprint(uv, dFdx(uv), dFdy(uv));
    MaterialDetail detail = material_details[material];
    if (detail.least_coverage > 0.0 &&
        base_of(vec3(1.0), detail, at, color).a < detail.least_coverage) {
        discard;
    }
}
