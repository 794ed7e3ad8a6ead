// Points that share a disc of radius 1 evenly: one in the middle, then rings of 8, 16 and 24, each
// point for 1/49 of the area (preview/effects/depth_of_field.cpp).
const int disc_points = 49;

/// How much of a point at `distance` a circle of that radius covers: its edge is a texel wide.
float covered(float radius, float distance) {
    return clamp(radius - distance + 0.5, 0.0, 1.0);
}

/// The sum of covered() over the points of a disc of radius `reach`.
float covered_points(float radius, float reach) {
    return covered(radius, 0.0) + 8.0 * covered(radius, 2.0 / 7.0 * reach) +
           16.0 * covered(radius, 4.0 / 7.0 * reach) + 24.0 * covered(radius, 6.0 / 7.0 * reach);
}
