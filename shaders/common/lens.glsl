// A thin lens (preview/effects/depth_of_field.cpp): how far it spreads a point that lies out of
// focus. With the focal length f, the aperture f / N and the focus at z_f, the circle of a point at
// z has on the sensor the diameter f / N * f / (z_f - f) * |1 - z_f / z|.
layout(push_constant) uniform Push {
    float scale;      // texels of radius, metres: rows / 2 f^2 / (N sensor height)
    float focal;      // focal length, metres
    float near_plane; // metres
    float focus;      // 1 / z_f; negative: at `place`
    float largest;    // radius, texels
    int place_x, place_y;
} lens;

/// 1 / z_f.
float focus_of(sampler2D depths) {
    float focus = lens.focus;
    if (focus < 0.0) {
        focus = (1.0 - texelFetch(depths, ivec2(lens.place_x, lens.place_y), 0).r) / lens.near_plane;
    }
    return clamp(focus, 0.0, 0.5 / lens.focal);
}

/// Radius of the circle in texels of the picture: above 0 behind the focus, below 0 before it.
float radius_of(float depth, float focus) {
    float radius =
        lens.scale / (1.0 - lens.focal * focus) * (focus - (1.0 - depth) / lens.near_plane);
    return clamp(radius, -lens.largest, lens.largest);
}

/// How much of a texel with that radius is spread over the picture as what lies before the focus,
/// and how much is blurred as what lies behind it. A circle within a texel stays sharp.
float near_share(float radius) {
    return clamp(-radius - 0.5, 0.0, 1.0);
}
float far_share(float radius) {
    return clamp(radius - 0.5, 0.0, 1.0);
}
