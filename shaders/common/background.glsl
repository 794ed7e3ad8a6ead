// What the eye sees where there is no surface. After `view`, `environment`, has_environment and
// common/surroundings.glsl.
#include "common/environment_light.glsl"

/// Of a unit direction, in a picture of so many rows.
vec3 background_at(vec3 direction, float rows) {
    if (!has_environment) {
        return vec3(0.0);
    }
    return surroundings_kind == kind_gradient
               ? environment_radiance(direction, 0.0)
               : surroundings_behind(direction, 2.0 * length(view.up.xyz) / rows);
}
