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
    float least_coverage = material_details[material].least_coverage;
    if (least_coverage > 0.0 && base_of(vec3(1.0), material, at, color).a < least_coverage) {
        discard;
    }
}
