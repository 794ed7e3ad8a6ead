// Points that share a disc of radius 1 evenly: one in the middle, then rings of 8, 16, 24 and so on,
// each point for the same share of the area (preview/effects/depth_of_field.cpp).
const int most_disc_points = 169; // of six rings

/// How much of a point at `distance` a circle of that radius covers: its edge is a texel wide.
float covered(float radius, float distance) {
    return clamp(radius - distance + 0.5, 0.0, 1.0);
}
