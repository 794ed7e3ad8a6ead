float cross_2d(vec2 a, vec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// Perspective-correct weights of the corners at a point of the screen, which may lie outside: the
/// areas of its triangles with two corners each, all in clip space relative to the point, where
/// they keep their digits also for triangles smaller than a pixel.
vec3 areas_at(vec2 screen, vec4 a, vec4 b, vec4 c) {
    vec2 to_a = a.xy - screen * a.w, to_b = b.xy - screen * b.w, to_c = c.xy - screen * c.w;
    vec3 areas = vec3(cross_2d(to_b, to_c), cross_2d(to_c, to_a), cross_2d(to_a, to_b));
    return areas * sign(areas.x + areas.y + areas.z);
}

vec3 shares_of(vec3 areas) {
    float sum = areas.x + areas.y + areas.z;
    return sum > 0.0 ? areas / sum : vec3(1.0 / 3.0);
}

/// Centres just outside by the rounding of vertices are moved in.
vec3 weights_at(vec2 screen, vec4 a, vec4 b, vec4 c) {
    return shares_of(max(areas_at(screen, a, b, c), 0.0));
}
