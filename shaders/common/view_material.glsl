// A debug view of the materials whose numbers an image holds. Who includes this defines
// shown_material(); where there is no surface the view is black.
#define VIEW_UNSIGNED
#include "common/scene.glsl"
#include "common/view.glsl"
layout(std430, binding = 2) readonly buffer Materials { Material materials[]; };

vec3 shown_material(Material material);

vec3 shown(uvec4 texel) {
    return texel.r > 0u ? shown_material(materials[texel.r - 1u]) : vec3(0.0);
}
