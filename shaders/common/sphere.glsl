// Pictures of all directions: u turns to the right, with -z in the middle; v goes down from +y.
#ifndef SPHERE_GLSL
#define SPHERE_GLSL

vec2 sphere_uv(vec3 direction) {
    const float pi = 3.14159265358979;
    // At the poles any turn will do.
    float turn = abs(direction.x) + abs(direction.z) > 1e-7 ? atan(direction.x, -direction.z) : 0.0;
    return vec2(turn / (2.0 * pi) + 0.5, acos(clamp(direction.y, -1.0, 1.0)) / pi);
}

vec3 sphere_direction(vec2 uv) {
    const float pi = 3.14159265358979;
    float turn = (uv.x - 0.5) * 2.0 * pi;
    float across = sin(uv.y * pi);
    return vec3(across * sin(turn), cos(uv.y * pi), -across * cos(turn));
}

/// The solid angle of a texel in that row of a picture of that size.
float sphere_texel(int row, ivec2 size) {
    const float pi = 3.14159265358979;
    float top = cos(float(row) / float(size.y) * pi);
    float bottom = cos(float(row + 1) / float(size.y) * pi);
    return 2.0 * pi / float(size.x) * (top - bottom);
}

#endif
