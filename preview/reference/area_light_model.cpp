#include "preview/reference/area_light_model.h"

#include "preview/reference/area_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace preview::reference {

using glm::dvec3;
using lutlib::RgbD;

namespace {

constexpr double pi = std::numbers::pi;

/// Lights are no nearer than a millimetre.
constexpr double nearest = 1e-3;

double distance_to(dvec3 place) {
    return std::max(glm::length(place), nearest);
}

double angle_between(dvec3 a, dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The mean of 1 / (1 + t^2)^2 from 0 to x.
double mean_falloff(double x) {
    return x > 1e-6 ? (std::atan(x) / x + 1 / (1 + x * x)) / 2 : 1;
}

/// What stands for a light.
struct Sample {
    double irradiance = 0;         ///< per unit of intensity
    dvec3 towards{0};              ///< the point, in metres
    double inverse = 0;            ///< the mean of 1 / d^2
    double before = 0, behind = 0; ///< half the angles from that point to the light's ends
};

/// Of a line through `a` along `step`, in steps, the place nearest to the line along unit `ray`.
double nearest_step(dvec3 a, dvec3 step, dvec3 ray) {
    const dvec3 beside = a - ray * glm::dot(ray, a), moved = step - ray * glm::dot(ray, step);
    return -glm::dot(beside, moved) / std::max(glm::dot(moved, moved), 1e-9);
}

Sample rod(const AreaLight& light, dvec3 normal, dvec3 mirrored) {
    const dvec3 a = light.centre - light.extent, b = light.centre + light.extent;
    Sample out;
    out.irradiance = line_irradiance(normal, a, b);
    out.towards = a + std::clamp(nearest_step(a, b - a, mirrored), 0.0, 1.0) * (b - a);
    out.before = angle_between(out.towards, a) / 2;
    out.behind = angle_between(out.towards, b) / 2;
    // Over a line the mean of 1 / d^2 is the angle that it spans, over twice the triangle.
    const double area = glm::length(glm::cross(a, b));
    out.inverse = area > 1e-4 ? angle_between(a, b) / area : std::pow(distance_to(out.towards), -2);
    return out;
}

Sample ring(const AreaLight& light, dvec3 normal, dvec3 mirrored) {
    const double radius = std::max(glm::length(light.extent), 1e-4);
    const dvec3 axis = light.extent == dvec3(0) ? dvec3(0, 1, 0) : light.extent / radius;
    const dvec3 x = across(axis), y = glm::cross(axis, x);
    // An octagon whose mean square of radii is the ring's.
    const double half_side = std::sin(pi / 8);
    const double corner_radius = radius / std::sqrt(1 - half_side * half_side * 2 / 3);
    const auto outward_at = [&](int corner) {
        return std::cos(corner * pi / 4) * x + std::sin(corner * pi / 4) * y;
    };
    Sample out;
    dvec3 outward(0);
    double best = -2;
    for (int corner = 1; corner <= 8; ++corner) {
        const dvec3 here = light.centre + corner_radius * outward_at(corner);
        out.irradiance +=
            line_irradiance(normal, light.centre + corner_radius * outward_at(corner - 1), here) /
            8;
        const double facing = glm::dot(mirrored, here) / std::max(glm::length(here), 1e-6);
        if (facing > best) {
            best = facing;
            outward = outward_at(corner);
        }
    }
    // Twice along the tangent to what is nearest, at most an eighth of a turn.
    for (int i = 0; i < 2; ++i) {
        const dvec3 along = glm::cross(axis, outward);
        const double aside =
            nearest_step(light.centre + radius * outward, along, mirrored) / radius;
        outward = glm::normalize(outward + std::clamp(aside, -1.0, 1.0) * along);
    }
    out.towards = light.centre + radius * outward;
    out.inverse = std::pow(distance_to(out.towards), -2);
    out.before = out.behind = pi * radius / 2 / distance_to(out.towards);
    return out;
}

Sample ball(const AreaLight& light, dvec3 normal) {
    const double distance = distance_to(light.centre);
    return {.irradiance = std::max(glm::dot(normal, light.centre), 0.0) / std::pow(distance, 3),
            .towards = light.centre,
            .inverse = 1 / (distance * distance)};
}

/// How much of the highlight's peak the whole light has on average.
double mean_of_lobe(const AreaLight& light, const Sample& sample, double across_axis,
                    double width) {
    const double across = light.thickness / 2 / (distance_to(sample.towards) * width);
    if (light.shape == PointLight::Shape::point) {
        return 1 / (1 + 1.2 * across * across);
    }
    const double total = sample.before + sample.behind;
    const auto part = [&](double reach) {
        return reach * mean_falloff(across_axis * reach / width);
    };
    return (total > 1e-6 ? (part(sample.before) + part(sample.behind)) / total : 0) *
           mean_falloff(across);
}

} // namespace

double line_irradiance(dvec3 normal, dvec3 a, dvec3 b) {
    const double length = glm::length(b - a);
    const double over_a = glm::dot(normal, a), over_b = glm::dot(normal, b);
    if (over_a <= 0 && over_b <= 0) {
        return 0;
    }
    if (!(length > 0)) {
        return over_a / std::pow(distance_to(a), 3);
    }
    const dvec3 along = (b - a) / length;
    // From the foot of the perpendicular; only what is above the horizon shines.
    double first = glm::dot(a, along), last = first + length;
    const double horizon = first + length * over_a / (over_a - over_b);
    first = over_a < 0 ? horizon : first;
    last = over_b < 0 ? horizon : last;
    const dvec3 foot = a - glm::dot(a, along) * along;
    const double squared = std::max(glm::dot(foot, foot), 1e-18);
    // Of (n.foot + s n.along) / (squared + s^2)^(3/2).
    const auto antiderivative = [&](double s) {
        return (glm::dot(normal, foot) * s / squared - glm::dot(normal, along)) /
               std::sqrt(squared + s * s);
    };
    return (antiderivative(last) - antiderivative(first)) / length;
}

RgbD shade(const Surface& surface, dvec3 view, const AreaLight& light) {
    const dvec3 mirrored = 2 * glm::dot(view, surface.normal) * surface.normal - view;
    const Sample sample =
        light.shape == PointLight::Shape::rod    ? rod(light, surface.normal, mirrored)
        : light.shape == PointLight::Shape::ring ? ring(light, surface.normal, mirrored)
                                                 : ball(light, surface.normal);
    // What is thick reaches towards the mirrored ray.
    const dvec3 aside = mirrored * glm::dot(mirrored, sample.towards) - sample.towards;
    const dvec3 point = sample.towards +
                        aside * std::min(light.thickness / std::max(glm::length(aside), 1e-6), 1.0);
    const dvec3 direction = glm::normalize(point);
    const double alpha = std::pow(std::max(surface.roughness, least_roughness), 2);
    const dvec3 sum = view + direction;
    const double n_dot_h =
        std::clamp(glm::dot(surface.normal, sum) / std::max(glm::length(sum), 1e-9), 0.0, 1.0);
    const double width = std::sqrt(1 - n_dot_h * n_dot_h * (1 - alpha * alpha));
    const Lobes both = lobes(surface, view, direction);
    return both.diffuse * sample.irradiance +
           both.specular * (std::max(glm::dot(surface.normal, direction), 0.0) * sample.inverse *
                            mean_of_lobe(light, sample, 1.2, width));
}

} // namespace preview::reference
