// Where a comparison shows side A, and the border: a shape as preview/finish/wipe.h has it.
bool is_before_wipe(bool is_box, ivec2 at, vec4 shape) {
    vec2 centre = vec2(at) + 0.5;
    return is_box ? all(greaterThanEqual(centre, shape.xy)) && all(lessThan(centre, shape.zw))
                  : dot(centre, shape.xy) < shape.z;
}

/// Two texels wide at 1080 lines, at least one.
bool on_wipe(bool is_box, ivec2 at, ivec2 size, vec4 shape) {
    float half_width = max(float(size.y) / 1080.0, 0.5);
    vec2 centre = vec2(at) + 0.5;
    if (is_box) {
        vec2 outside = max(shape.xy - centre, centre - shape.zw);
        return abs(max(outside.x, outside.y)) <= half_width;
    }
    return abs(dot(centre, shape.xy) - shape.z) <= half_width;
}
