// Balls, rods and rings that shine, by their simplest approximations; the integrals that these stand
// for are in preview/reference/area_light.h, and docs/renderer-report.md has the errors. After
// common/scene.glsl and common/brdf.glsl.
//
// Diffuse: the irradiance of a line is exact, cut at the surface's horizon, and a ring is eight
// lines whose second moment is the ring's. Specular: all of the light shines from its point that is
// nearest to the mirrored ray (Karis 2013, "Real shading in Unreal Engine 4"), times the mean of
// the distribution's fall-off along the light on both sides of that point, for which
// 1 / (1 + x^2)^2 has a closed integral. A ball's is that over its disc.

const float shape_rod = 1.0, shape_ring = 2.0;
const bool has_rods = (area_shapes & 2) != 0, has_rings = (area_shapes & 4) != 0;

/// Irradiance per unit of intensity from a line between two places relative to the surface, by
/// their dot products: with the normal, with themselves, with each other; and the line's squared
/// length.
float line_irradiance(vec2 over, vec2 squared, float product, float length_squared) {
    float share = 1.0;
    if (over.x < 0.0 && over.y < 0.0) {
        return 0.0;
    }
    if (over.x * over.y < 0.0) {
        if (over.x < 0.0) {
            over = over.yx;
            squared = squared.yx;
        }
        // The second place moves up to the horizon.
        float cut = over.y / (over.y - over.x);
        share -= cut;
        squared.y += cut * (2.0 * (product - squared.y) + cut * length_squared);
        product += cut * (squared.x - product);
        over.y = 0.0;
    }
    squared = max(squared, 1e-6);
    vec2 inverse = inversesqrt(squared);
    float far = squared.x * inverse.x * squared.y * inverse.y;
    return share * dot(over, inverse) / max(far + product, 1e-6);
}

/// Mean of 1 / (1 + x^2)^2 from 0 to x.
float mean_falloff(float x) {
    return x > 1e-3 ? 0.5 * (1.0 / (1.0 + x * x) + atan(x) / x) : 1.0;
}

/// Where a line through a place `a` along a step comes nearest to a ray from the surface, in steps:
/// by the dot products of the step with the ray, with `a` and with itself, and of the ray with `a`.
float nearest_step(float ray_step, float a_step, float step_step, float ray_a) {
    return (ray_a * ray_step - a_step) / max(step_step - ray_step * ray_step, 1e-9);
}

struct AreaSample {
    float irradiance; // per unit of intensity
    vec3 towards;     // to the point that stands for the light, in metres
    float inverse;    // 1 / d^2 of it
    vec2 reach;       // half the angles to both ends of the light seen from it
};

AreaSample sample_rod(vec3 centre, vec3 extent, vec3 normal, vec3 mirrored) {
    vec3 a = centre - extent, b = centre + extent;
    float squared_a = dot(a, a), squared_b = dot(b, b), product = dot(a, b);
    AreaSample s;
    s.irradiance = line_irradiance(vec2(dot(normal, a), dot(normal, b)),
                                   vec2(squared_a, squared_b), product,
                                   4.0 * dot(extent, extent));
    vec3 step = b - a;
    float t = nearest_step(dot(mirrored, step), dot(a, step), dot(step, step), dot(mirrored, a));
    t = clamp(t, 0.0, 1.0);
    s.towards = a + t * step;
    // By sines and cosines, as an arc cosine does not resolve small angles. The sines are parts of
    // |a x b|.
    float area = length(cross(a, b));
    vec2 cosines = mix(vec2(squared_a, product), vec2(product, squared_b), t);
    vec2 angles = atan(max(vec2(t, 1.0 - t) * area, 1e-12), cosines);
    s.reach = 0.5 * angles;
    // The mean of 1 / d^2 over the line.
    s.inverse = area > 1e-4 ? (angles.x + angles.y) / area
                            : 1.0 / max(dot(s.towards, s.towards), 1e-6);
    return s;
}

/// A linear function of places on a circle at the corners of its octagon: the first four by eighths
/// of a turn, and what lies opposite them. `across`: along the circle's two axes, times its radius.
struct Corners {
    vec4 near, opposite;
};

Corners at_corners(float centre, vec2 across) {
    const float diagonal = 0.70710678;
    vec4 aside = vec4(across.x, diagonal * (across.x + across.y), across.y,
                      diagonal * (across.y - across.x));
    return Corners(centre + aside, centre - aside);
}

/// The sum over the octagon's edges, of which `edge` is the squared length.
float octagon_irradiance(Corners over, Corners squared, float edge) {
    float sum = 0.0;
    vec2 last = vec2(over.opposite.w, squared.opposite.w);
    for (int i = 0; i < 8; ++i) {
        vec2 next = i < 4 ? vec2(over.near[i], squared.near[i])
                          : vec2(over.opposite[i - 4], squared.opposite[i - 4]);
        sum += line_irradiance(vec2(last.x, next.x), vec2(last.y, next.y),
                               0.5 * (last.y + next.y - edge), edge);
        last = next;
    }
    return sum;
}

/// The same above the horizon, four edges at once. `inverse`: 1 / root of `squared`.
float octagon_irradiance_above(Corners over, Corners squared, Corners inverse, float edge) {
    vec4 near = over.near * inverse.near, opposite = over.opposite * inverse.opposite;
    vec4 far_near = squared.near * inverse.near;
    vec4 far_opposite = squared.opposite * inverse.opposite;
    vec4 products = 0.5 * (squared.near + vec4(squared.near.yzw, squared.opposite.x) - edge);
    vec4 shares = (near + vec4(near.yzw, opposite.x)) /
                  max(far_near * vec4(far_near.yzw, far_opposite.x) + products, 1e-6);
    products = 0.5 * (squared.opposite + vec4(squared.opposite.yzw, squared.near.x) - edge);
    shares += (opposite + vec4(opposite.yzw, near.x)) /
              max(far_opposite * vec4(far_opposite.yzw, far_near.x) + products, 1e-6);
    return dot(shares, vec4(1.0));
}

// By dot products alone: a corner is centre + cos(t) x + sin(t) y, and those of neighbours are
// known from their distance.
AreaSample sample_ring(vec3 centre, vec3 extent, vec3 normal, vec3 mirrored) {
    float radius = max(length(extent), 1e-4);
    // A ring without a radius lies flat.
    vec3 axis = dot(extent, extent) > 0.0 ? extent / radius : vec3(0.0, 1.0, 0.0);
    vec3 x = normalize(cross(axis, abs(axis.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 y = cross(axis, x);
    float corner_radius = 1.0527 * radius, square = corner_radius * corner_radius;
    const float least = 1e-6;
    vec2 over_across = corner_radius * vec2(dot(normal, x), dot(normal, y));
    float over_centre = dot(normal, centre);
    Corners over = at_corners(over_centre, over_across);
    vec2 centre_across = vec2(dot(centre, x), dot(centre, y));
    Corners squared = at_corners(dot(centre, centre) + square,
                                 2.0 * corner_radius * centre_across);
    squared.near = max(squared.near, least);
    squared.opposite = max(squared.opposite, least);
    Corners inverse = Corners(inversesqrt(squared.near), inversesqrt(squared.opposite));
    float edge = square * (2.0 - sqrt(2.0));
    AreaSample s;
    s.irradiance = over_centre >= length(over_across)
                       ? octagon_irradiance_above(over, squared, inverse, edge)
                       : octagon_irradiance(over, squared, edge);
    s.irradiance /= 8.0;
    // From the corner that is nearest to the mirrored ray.
    float facing_centre = dot(mirrored, centre);
    vec2 facing_across = vec2(dot(mirrored, x), dot(mirrored, y));
    Corners facing = at_corners(facing_centre, corner_radius * facing_across);
    vec4 near = facing.near * inverse.near, opposite = facing.opposite * inverse.opposite;
    const float diagonal = 0.70710678;
    const vec2 turns[4] = vec2[4](vec2(1.0, 0.0), vec2(diagonal, diagonal), vec2(0.0, 1.0),
                                  vec2(-diagonal, diagonal));
    float best = near.x;
    vec2 turn = turns[0];
    for (int i = 0; i < 4; ++i) {
        if (near[i] > best) {
            best = near[i];
            turn = turns[i];
        }
        if (opposite[i] > best) {
            best = opposite[i];
            turn = -turns[i];
        }
    }
    for (int i = 0; i < 2; ++i) {
        // Along the tangent, by the angle whose tangent that is.
        vec2 tangent = vec2(-turn.y, turn.x);
        float aside = nearest_step(dot(facing_across, tangent), dot(centre_across, tangent), 1.0,
                                   facing_centre + radius * dot(facing_across, turn));
        aside = clamp(aside / radius, -1.0, 1.0);
        turn = (turn + aside * tangent) * inversesqrt(1.0 + aside * aside);
    }
    s.towards = centre + radius * (turn.x * x + turn.y * y);
    float distance_squared = max(dot(s.towards, s.towards), 1e-6);
    s.inverse = 1.0 / distance_squared;
    s.reach = vec2(0.5 * pi * radius * inversesqrt(distance_squared));
    return s;
}

AreaSample sample_ball(vec3 centre, vec3 normal) {
    float inverse = 1.0 / max(dot(centre, centre), 1e-6);
    return AreaSample(max(dot(normal, centre), 0.0) * inverse * sqrt(inverse), centre, inverse,
                      vec2(0.0));
}

/// Radiance towards `view` per unit of the light's intensity.
vec3 shade_area(Light light, vec3 position, vec3 normal, vec3 view, vec3 albedo, float roughness,
                float metalness) {
    vec3 centre = light.position_layer.xyz - position, extent = light.extent_shape.xyz;
    vec3 mirrored = reflect(-view, normal);
    float shape = light.extent_shape.w;
    bool is_rod = has_rods && shape == shape_rod, is_ring = has_rings && shape == shape_ring;
    AreaSample s = is_rod    ? sample_rod(centre, extent, normal, mirrored)
                   : is_ring ? sample_ring(centre, extent, normal, mirrored)
                             : sample_ball(centre, normal);
    float far = sqrt(max(dot(s.towards, s.towards), 1e-6));
    // The tube's thickness reaches towards the mirrored ray.
    vec3 aside = mirrored * dot(mirrored, s.towards) - s.towards;
    float thickness = light.up_thickness.w;
    vec3 point = s.towards + aside * min(thickness / max(length(aside), 1e-6), 1.0);
    vec3 direction = normalize(point);
    Lobes lobes = lobes_of(normal, view, direction, albedo, roughness, metalness);
    // Across the plane of incidence the half vector turns by more than half of what the light does.
    vec2 ends = 1.2 * s.reach * lobes.sharpness;
    float across = 0.5 * thickness / far * lobes.sharpness;
    float mean;
    if (is_rod || is_ring) {
        float first = mean_falloff(ends.x), second = is_ring ? first : mean_falloff(ends.y);
        mean = (s.reach.x * first + s.reach.y * second) / max(s.reach.x + s.reach.y, 1e-6) *
               mean_falloff(across);
    } else {
        mean = 1.0 / (1.0 + 1.2 * across * across);
    }
    return lobes.diffuse * s.irradiance +
           lobes.specular * (max(dot(normal, direction), 0.0) * s.inverse * mean);
}
