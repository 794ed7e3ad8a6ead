// What the frame has of light: lighting_constants() of preview/passes/lighting.h. Number 4 is
// common/surroundings.glsl's.
#ifndef LIGHTING_CONSTANTS_GLSL
#define LIGHTING_CONSTANTS_GLSL

layout(constant_id = 0) const bool has_shadows = true;
layout(constant_id = 1) const bool has_environment = true;
layout(constant_id = 2) const bool has_spots = true;
layout(constant_id = 3) const bool has_suns = true;
layout(constant_id = 5) const bool has_occlusion = false;
layout(constant_id = 6) const int area_shapes = 0; // bits, by the numbers of the shapes
layout(constant_id = 7) const int soft_boxes = 0; // of the environment
layout(constant_id = 8) const bool has_ends = false; // some light has a reach
layout(constant_id = 9) const bool takes_light = true; // else surfaces only give their own
layout(constant_id = 10) const int shadow_side = 3; // texels of the filter's square
layout(constant_id = 11) const int shadow_places = 1; // of such squares

#endif
