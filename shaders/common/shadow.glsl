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
float reached_about(vec2 place, vec2 origin, float layer, float texel, float depth, vec2 slope) {
    vec2 lowest = floor(place), part = place - lowest;
    lowest -= float(shadow_side / 2);
    float own_lowest = depth + dot(slope, lowest - origin);
    vec2 between = (lowest + 1.0) * texel; // of the lowest four
    float sum = 0.0;
    for (int y = 0; y <= shadow_side / 2; ++y) {
        for (int x = 0; x <= shadow_side / 2; ++x) {
            vec2 step = vec2(2 * x, 2 * y);
            // From the lower left against the clock.
            vec4 stored = textureGather(shadow_maps, vec3(between + step * texel, layer));
            float own = own_lowest + dot(slope, step);
            vec4 owns = own + vec4(slope.y, slope.x + slope.y, slope.x, 0.0);
            vec4 reached = vec4(greaterThanEqual(stored, owns));
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
    float layer = light.position_layer.w;
    // In the frame of the map: to the right, up and forward.
    vec3 seen, facing;
    if (light.faces.x != 0u) {
        vec3 a = abs(from);
        float largest = max(a.x, max(a.y, a.z));
        bool is_x = a.x == largest, is_y = a.y == largest;
        seen = is_x ? from.yzx : is_y ? from.zxy : from;
        facing = is_x ? normal.yzx : is_y ? normal.zxy : normal;
        bool is_negative = seen.z < 0.0;
        uint face = (is_x ? 0u : is_y ? 2u : 4u) + (is_negative ? 1u : 0u);
        if ((light.faces.x >> face & 1u) == 0u) {
            return 1.0;
        }
        layer += float(face);
        seen.z = largest;
        facing.z = is_negative ? -facing.z : facing.z;
    } else {
        mat3 frame = mat3(light.right_tangent.xyz, light.up_thickness.xyz, light.forward.xyz);
        seen = from * frame;
        facing = normal * frame;
    }
    seen += facing * (0.5 * light.intensity_texel.w * (is_sun(light) ? 1.0 : seen.z));
    float near = light.range.y, far = light.range.z;
    // A sun's shadows go on behind the box of the casters.
    if (!(seen.z > near && (is_sun(light) || seen.z < far))) {
        return 1.0;
    }
    vec2 screen = seen.xy / (is_sun(light) ? tangent : seen.z * tangent);
    if (any(greaterThan(abs(screen), vec2(1.0)))) {
        return 1.0;
    }
    float size = float(textureSize(shadow_maps, 0).x), texel = 1.0 / size;
    float depth;
    vec2 slope = -2.0 * texel * tangent * facing.xy;
    if (is_sun(light)) {
        depth = (seen.z - near) / (far - near);
        slope *= depth < 1.0 ? 1.0 / ((far - near) * min(facing.z, -0.05)) : 0.0;
        depth = min(depth, 1.0);
    } else {
        // Depth is far / (far - near) (1 - near / z), and 1 / z of a plane changes evenly over the map.
        float scale = near * far / (far - near);
        depth = far / (far - near) - scale / seen.z;
        slope *= scale / min(dot(facing, seen), -0.05 * length(seen));
    }
    vec2 place = (screen * 0.5 + 0.5) * size - 0.5;
    if (shadow_places == 1) {
        return reached_about(place, place, layer, texel, depth, slope);
    }
    float sum = 0.0;
    for (int i = 0; i < shadow_places; ++i) {
        sum += reached_about(place + disc_places[i], place, layer, texel, depth, slope);
    }
    return sum / float(shadow_places);
}
