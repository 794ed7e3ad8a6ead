// Points that the camera sees, relative to it. After common/scene.glsl.

/// The ray through a place of the picture in texels; z along it has the view depth z.
vec3 ray_at(View view, vec2 place, vec2 size) {
    vec2 screen = place / size * 2.0 - 1.0;
    return view.forward.xyz + screen.x * view.right.xyz + screen.y * view.up.xyz;
}

float z_of(View view, float depth) {
    return view.position_near.w / (1.0 - depth);
}
