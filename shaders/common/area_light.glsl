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

/// Irradiance per unit of intensity from a line between two places relative to the surface.
float line_irradiance(vec3 a, vec3 b, vec3 normal) {
    float over_a = dot(normal, a), over_b = dot(normal, b);
    float share = 1.0;
    if (over_a < 0.0 && over_b < 0.0) {
        return 0.0;
    }
    if (over_a < 0.0) {
        float cut = over_a / (over_a - over_b);
        a = mix(a, b, cut);
        over_a = 0.0;
        share -= cut;
    } else if (over_b < 0.0) {
        float cut = over_b / (over_b - over_a);
        b = mix(b, a, cut);
        over_b = 0.0;
        share -= cut;
    }
    float far_a = max(length(a), 1e-3), far_b = max(length(b), 1e-3);
    return share * (over_a / far_a + over_b / far_b) / max(far_a * far_b + dot(a, b), 1e-6);
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
    s.irradiance = line_irradiance(a, b, normal);
    s.towards = a + clamp(nearest_step(a, b - a, mirrored), 0.0, 1.0) * (b - a);
    s.reach = 0.5 * vec2(angle_between(s.towards, a), angle_between(s.towards, b));
    // The mean of 1 / d^2 over the line.
    float area = length(cross(a, b));
    s.inverse = area > 1e-4 ? angle_between(a, b) / area
                            : 1.0 / max(dot(s.towards, s.towards), 1e-6);
    return s;
}

AreaSample sample_ring(vec3 centre, vec3 extent, vec3 normal, vec3 mirrored) {
    float radius = max(length(extent), 1e-4);
    // A ring without a radius lies flat.
    vec3 axis = dot(extent, extent) > 0.0 ? normalize(extent) : vec3(0.0, 1.0, 0.0);
    vec3 x = normalize(cross(axis, abs(axis.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 y = cross(axis, x);
    const float eighth = 6.28318530718 / 8.0;
    const float polygon = 1.0527;
    AreaSample s;
    s.irradiance = 0.0;
    float turn = 0.0, best = -2.0;
    vec3 last = centre + polygon * radius * x;
    for (int i = 1; i <= 8; ++i) {
        float angle = eighth * float(i);
        vec3 next = centre + polygon * radius * (cos(angle) * x + sin(angle) * y);
        s.irradiance += line_irradiance(last, next, normal) / 8.0;
        float facing = dot(next, mirrored) * inversesqrt(max(dot(next, next), 1e-12));
        if (facing > best) {
            best = facing;
            turn = angle;
        }
        last = next;
    }
    for (int i = 0; i < 2; ++i) {
        vec3 outward = cos(turn) * x + sin(turn) * y;
        vec3 along = cos(turn) * y - sin(turn) * x;
        turn += atan(clamp(nearest_step(centre + radius * outward, along, mirrored) / radius, -1.0,
                           1.0));
    }
    s.towards = centre + radius * (cos(turn) * x + sin(turn) * y);
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
    AreaSample s = shape == shape_rod    ? sample_rod(centre, extent, normal, mirrored)
                   : shape == shape_ring ? sample_ring(centre, extent, normal, mirrored)
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
    if (shape == shape_rod || shape == shape_ring) {
        float total = max(s.reach.x + s.reach.y, 1e-6);
        mean = (s.reach.x * mean_falloff(ends.x) + s.reach.y * mean_falloff(ends.y)) / total *
               mean_falloff(across);
    }
    Lobes lobes = lobes_of(normal, view, direction, albedo, roughness, metalness);
    return lobes.diffuse * s.irradiance +
           lobes.specular * (max(dot(normal, direction), 0.0) * s.inverse * mean);
}
