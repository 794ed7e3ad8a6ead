// How much of a light reaches a point, by its shadow maps. After common/scene.glsl and shadow_maps.

// Places of squares in texels about a point: of a Poisson disc, about its middle on average.
const vec2 disc_places[8] =
    vec2[8](vec2(-1.806, 1.313), vec2(2.337, 0.248), vec2(0.067, -0.783), vec2(-1.781, -0.392),
            vec2(1.799, -1.499), vec2(-0.298, 2.377), vec2(-0.938, -2.209), vec2(0.62, 0.945));

/// Of the columns or rows 2 i and 2 i + 1 of a square that lies `part` of a texel off: the outermost
/// count in part.
vec2 shares_of_pair(int i, float part) {
    return vec2(i == 0 ? 1.0 - part : 1.0, 2 * i + 1 == shadow_side ? part : 1.0);
}

/// The share of a square of shadow_side by shadow_side texels about a place of the map that the
/// light reaches. Its surface has the depth `depth` at `origin`, and `slope` more a texel.
float reached_about(vec2 place, vec2 origin, float layer, vec2 size, float depth, vec2 slope) {
    vec2 first = floor(place), part = place - first;
    float sum = 0.0;
    for (int y = 0; y <= shadow_side / 2; ++y) {
        for (int x = 0; x <= shadow_side / 2; ++x) {
            vec2 corner = first - float(shadow_side / 2 - 1) + vec2(2 * x, 2 * y);
            // From the lower left against the clock.
            vec4 stored = textureGather(shadow_maps, vec3(corner / size, layer));
            vec2 low = corner - 1.0 - origin;
            float expected = depth + dot(slope, low);
            vec4 own = expected + vec4(slope.y, slope.x + slope.y, slope.x, 0.0);
            vec4 reached = vec4(greaterThanEqual(stored, own));
            vec2 wx = shares_of_pair(x, part.x), wy = shares_of_pair(y, part.y);
            sum += dot(reached, vec4(wx.x * wy.y, wx.y * wy.y, wx.y * wy.x, wx.x * wy.x));
        }
    }
    float all = float(shadow_side * shadow_side);
    return sum > all - 1e-4 ? 1.0 : sum / all; // the shares sum to that but for rounding
}

/// The share of the filter's texels of the map about the point that the light reaches, 0..1; 1
/// outside the maps. Every texel's depth is compared with the surface's own plane at the texel's
/// centre, so that no surface shadows itself however it slants and no bias eats what touches it.
/// `normal` is that of the geometry; half a texel along it stands for the facets of round things.
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
    if (shadow_places == 1) {
        return reached_about(place, place, layer, size, depth, slope);
    }
    float sum = 0.0;
    for (int i = 0; i < shadow_places; ++i) {
        sum += reached_about(place + disc_places[i], place, layer, size, depth, slope);
    }
    return sum / float(shadow_places);
}
