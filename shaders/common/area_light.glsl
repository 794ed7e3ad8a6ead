// Balls, rods and rings that shine, by their simplest approximations; the integrals that these stand
// for, with their errors, are in preview/reference/area_light.h. After common/scene.glsl and
// common/brdf.glsl.
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

float angle_between(vec3 a, vec3 b) {
    return acos(clamp(dot(a, b) * inversesqrt(max(dot(a, a) * dot(b, b), 1e-12)), -1.0, 1.0));
}

/// Where a line through `a` along `step` comes nearest to a ray from the surface, in steps.
float nearest_step(vec3 a, vec3 step, vec3 ray) {
    float along = dot(ray, step);
    return (dot(ray, a) * along - dot(a, step)) / max(dot(step, step) - along * along, 1e-9);
}

struct AreaSample {
    float irradiance; // per unit of intensity
    vec3 towards;     // to the point that stands for the light, in metres
    float inverse;    // 1 / d^2 of it
    vec2 reach;       // half the angles to both ends of the light seen from it
};

AreaSample sample_rod(vec3 centre, vec3 extent, vec3 normal, vec3 mirrored) {
    vec3 a = centre - extent, b = centre + extent;
    AreaSample s;
    s.irradiance =
        line_irradiance(vec2(dot(normal, a), dot(normal, b)), vec2(dot(a, a), dot(b, b)),
                        dot(a, b), 4.0 * dot(extent, extent));
    s.towards = a + clamp(nearest_step(a, b - a, mirrored), 0.0, 1.0) * (b - a);
    s.reach = 0.5 * vec2(angle_between(s.towards, a), angle_between(s.towards, b));
    // The mean of 1 / d^2 over the line.
    float area = length(cross(a, b));
    s.inverse = area > 1e-4 ? angle_between(a, b) / area
                            : 1.0 / max(dot(s.towards, s.towards), 1e-6);
    return s;
}

// By dot products alone: a corner is centre + cos(t) x + sin(t) y, and those of neighbours are
// known from their distance.
AreaSample sample_ring(vec3 centre, vec3 extent, vec3 normal, vec3 mirrored) {
    float radius = max(length(extent), 1e-4);
    // A ring without a radius lies flat.
    vec3 axis = dot(extent, extent) > 0.0 ? extent / radius : vec3(0.0, 1.0, 0.0);
    vec3 x = normalize(cross(axis, abs(axis.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 y = cross(axis, x);
    const float diagonal = 0.70710678;
    float corner_radius = 1.0527 * radius, square = corner_radius * corner_radius;
    float edge = square * (2.0 - 2.0 * diagonal);
    vec2 over_of = corner_radius * vec2(dot(normal, x), dot(normal, y));
    vec2 far_of = 2.0 * corner_radius * vec2(dot(centre, x), dot(centre, y));
    vec2 facing_of = corner_radius * vec2(dot(mirrored, x), dot(mirrored, y));
    float over_centre = dot(normal, centre), far_centre = dot(centre, centre) + square;
    float facing_centre = dot(mirrored, centre);
    AreaSample s;
    s.irradiance = 0.0;
    float best = -2.0;
    vec2 turn = vec2(1.0, 0.0), best_turn = turn;
    vec2 last = vec2(over_centre + over_of.x, far_centre + far_of.x);
    for (int i = 0; i < 8; ++i) {
        turn = diagonal * vec2(turn.x - turn.y, turn.x + turn.y);
        vec2 next = vec2(over_centre + dot(turn, over_of), far_centre + dot(turn, far_of));
        s.irradiance += line_irradiance(vec2(last.x, next.x), vec2(last.y, next.y),
                                        0.5 * (last.y + next.y - edge), edge);
        float facing =
            (facing_centre + dot(turn, facing_of)) * inversesqrt(max(next.y, 1e-12));
        if (facing > best) {
            best = facing;
            best_turn = turn;
        }
        last = next;
    }
    s.irradiance /= 8.0;
    vec3 outward = best_turn.x * x + best_turn.y * y;
    for (int i = 0; i < 2; ++i) {
        vec3 along = cross(axis, outward);
        // By the angle whose tangent that is.
        float aside = clamp(nearest_step(centre + radius * outward, along, mirrored) / radius, -1.0,
                            1.0);
        outward = (outward + aside * along) * inversesqrt(1.0 + aside * aside);
    }
    s.towards = centre + radius * outward;
    float squared = max(dot(s.towards, s.towards), 1e-6);
    s.inverse = 1.0 / squared;
    s.reach = vec2(0.5 * pi * radius * inversesqrt(squared));
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
    vec3 halfway = view + direction;
    halfway *= inversesqrt(max(dot(halfway, halfway), 1e-18));
    float alpha = max(roughness, least_roughness);
    alpha *= alpha;
    float n_dot_h = clamp(dot(normal, halfway), 0.0, 1.0);
    float width = sqrt(n_dot_h * n_dot_h * (alpha * alpha - 1.0) + 1.0);
    // Across the plane of incidence the half vector turns by more than half of what the light does.
    vec2 ends = 1.2 * s.reach / width;
    float across = 0.5 * thickness / (far * width);
    float mean = 1.0 / (1.0 + 1.2 * across * across);
    if (is_rod || is_ring) {
        float total = max(s.reach.x + s.reach.y, 1e-6);
        mean = (s.reach.x * mean_falloff(ends.x) + s.reach.y * mean_falloff(ends.y)) / total *
               mean_falloff(across);
    }
    Lobes lobes = lobes_of(normal, view, direction, albedo, roughness, metalness);
    return lobes.diffuse * s.irradiance +
           lobes.specular * (max(dot(normal, direction), 0.0) * s.inverse * mean);
}
