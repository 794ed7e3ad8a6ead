// How much of a light reaches a point, by its shadow maps. After common/scene.glsl and shadow_maps.

/// The share of a square of three by three texels of the map about the point that the light
/// reaches, 0..1; 1 outside the maps. Every texel's depth is compared with the surface's own plane
/// at the texel's centre, so that no surface shadows itself however it slants and no bias eats
/// what touches it. `normal` is that of the geometry; half a texel along it stands for the facets
/// of round things.
float lit(Light light, vec3 position, vec3 normal) {
    float tangent = light.right_tangent.w;
    vec3 from = position - (is_sun(light) ? light.extent_shape.xyz : light.position_layer.xyz);
    vec3 forward = light.forward.xyz, right = light.right_tangent.xyz, up = light.up_thickness.xyz;
    float layer = light.position_layer.w;
    if (light.faces.x != 0u) {
        vec3 a = abs(from);
        float largest = max(a.x, max(a.y, a.z));
        vec3 axis = a.x == largest   ? vec3(1.0, 0.0, 0.0)
                    : a.y == largest ? vec3(0.0, 1.0, 0.0)
                                     : vec3(0.0, 0.0, 1.0);
        float side = dot(axis, from) < 0.0 ? -1.0 : 1.0;
        uint face = 2u * uint(axis.y + 2.0 * axis.z) + (side < 0.0 ? 1u : 0u);
        if ((light.faces.x >> face & 1u) == 0u) {
            return 1.0;
        }
        layer += float(face);
        forward = side * axis;
        right = axis.zxy;
        up = axis.yzx;
    }
    from += normal * (0.5 * light.intensity_texel.w * (is_sun(light) ? 1.0 : dot(from, forward)));
    float z = dot(from, forward);
    float near = light.range.y, far = light.range.z;
    // A sun's shadows go on behind the box of the casters.
    if (!(z > near && (is_sun(light) || z < far))) {
        return 1.0;
    }
    vec2 screen = vec2(dot(from, right), dot(from, up)) / (is_sun(light) ? tangent : z * tangent);
    if (any(greaterThan(abs(screen), vec2(1.0)))) {
        return 1.0;
    }
    // Depth is far / (far - near) (1 - near / z), and 1 / z of a plane changes evenly over the map.
    float scale = near * far / (far - near);
    float depth = far / (far - near) - scale / z;
    float height = min(dot(normal, from), -0.05 * length(from));
    vec2 size = vec2(textureSize(shadow_maps, 0).xy);
    vec2 slope = -scale * tangent / height * vec2(dot(normal, right), dot(normal, up)) * 2.0 / size;
    if (is_sun(light)) {
        depth = (z - near) / (far - near);
        slope = depth < 1.0 ? -tangent / (far - near) / min(dot(normal, forward), -0.05) *
                                  vec2(dot(normal, right), dot(normal, up)) * 2.0 / size
                            : vec2(0.0);
        depth = min(depth, 1.0);
    }
    vec2 place = (screen * 0.5 + 0.5) * size - 0.5;
    vec2 first = floor(place), part = place - first;
    vec4 shares_x = vec4(1.0 - part.x, 1.0, 1.0, part.x);
    vec4 shares_y = vec4(1.0 - part.y, 1.0, 1.0, part.y);
    float sum = 0.0;
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            vec2 corner = first + vec2(2 * x, 2 * y);
            // From the lower left against the clock.
            vec4 stored = textureGather(shadow_maps, vec3(corner / size, layer));
            vec2 low = corner - 1.0 - place;
            float expected = depth + dot(slope, low);
            vec4 own = expected + vec4(slope.y, slope.x + slope.y, slope.x, 0.0);
            vec4 reached = vec4(greaterThanEqual(stored, own));
            vec2 wx = x == 0 ? shares_x.xy : shares_x.zw, wy = y == 0 ? shares_y.xy : shares_y.zw;
            sum += dot(reached, vec4(wx.x * wy.y, wx.y * wy.y, wx.y * wy.x, wx.x * wy.x));
        }
    }
    return sum > 8.9999 ? 1.0 : sum / 9.0; // the shares sum to 9 but for rounding
}
