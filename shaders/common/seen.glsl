// Points that the camera sees, relative to it. After common/scene.glsl.

/// The ray through a place of the picture in texels; z along it has the view depth z.
vec3 ray_at(View view, vec2 place, vec2 size) {
    vec2 screen = place / size * 2.0 - 1.0;
    return view.forward.xyz + screen.x * view.right.xyz + screen.y * view.up.xyz;
}

// The same in the picture's own frame: x and y are those of the picture from -1 to 1, times z, the view
// depth.

/// Of vectors of the world.
mat3 seen_from(View view) {
    vec3 right = view.right.xyz / dot(view.right.xyz, view.right.xyz);
    vec3 up = view.up.xyz / dot(view.up.xyz, view.up.xyz);
    return transpose(mat3(right, up, view.forward.xyz));
}

/// What makes with a point in the picture's frame the dot product of `normal` with the point.
vec3 plane_of(View view, vec3 normal) {
    return vec3(dot(normal, view.right.xyz), dot(normal, view.up.xyz),
                dot(normal, view.forward.xyz));
}

float z_of(View view, float depth) {
    return view.position_near.w / (1.0 - depth);
}
