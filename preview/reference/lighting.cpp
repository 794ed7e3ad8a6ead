#include "preview/reference/lighting.h"

#include "preview/reference/area_light_model.h"
#include "preview/reference/gradient.h"
#include "preview/reference/surroundings.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace preview::reference {

using glm::dvec3;
using lutlib::RgbD;

namespace {

void add(Lit& to, const RgbD& light, const RgbD& doubt) {
    to.light = to.light + light;
    to.doubt = to.doubt + doubt;
    for (std::size_t c = 0; c < 3; ++c) {
        to.magnitude[c] += std::abs(light[c]);
    }
}

RgbD times(const RgbD& a, const RgbD& b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}

/// KHR_lights_punctual's fall-off of a spot.
double in_cone(const LightBlock& light, dvec3 direction) {
    const double share =
        -glm::dot(dvec3(light.axis_scale), direction) * static_cast<double>(light.axis_scale.w) +
        static_cast<double>(light.range.x);
    return std::pow(std::clamp(share, 0.0, 1.0), 2);
}

/// KHR_lights_punctual's fall-off of a range; `squared` is that of the distance.
double within_reach(const LightBlock& light, double squared) {
    return std::max(1 - std::pow(squared * static_cast<double>(light.forward.w), 2), 0.0);
}

/// Per unit of the light's intensity, without its shadow.
RgbD shaded(const LitSurface& surface, const LightBlock& light) {
    const bool is_sun = light.range.w > 0;
    const dvec3 towards = dvec3(light.position_layer) - (is_sun ? dvec3(0) : surface.position);
    const double squared = std::max(glm::dot(towards, towards), 1e-6); // a millimetre at least
    if (!(squared < 1e30)) {
        return {};
    }
    const dvec3 direction = towards / std::sqrt(squared);
    const double arriving = within_reach(light, squared) * in_cone(light, direction);
    if (!(arriving > 0)) {
        return {};
    }
    const auto shape = static_cast<PointLight::Shape>(std::lround(light.extent_shape.w));
    if (shape == PointLight::Shape::point && !(light.up_thickness.w > 0)) {
        return shade(surface.material, surface.view, direction) * (arriving / squared);
    }
    return shade(surface.material, surface.view,
                 AreaLight{shape, towards, dvec3(light.extent_shape),
                           static_cast<double>(light.up_thickness.w)}) *
           arriving;
}

Arrival shadowed(const LitSurface& surface, const LightBlock& light, const Illumination& by) {
    if (light.position_layer.w < 0) {
        return {}; // it has no maps
    }
    const auto by_face = [&](dvec3 face) {
        return arrival(by.shadow_maps, light, *by.shadow_filter, surface.position, face);
    };
    Arrival out = by_face(surface.face);
    if (surface.is_face_in_doubt) {
        out.doubt += std::abs(out.share - by_face(-surface.face).share);
    }
    return out;
}

/// Lagarde and de Rousiers 2014, "Moving Frostbite to physically based rendering".
double mirrored_occlusion(double unoccluded, double n_dot_v, double roughness) {
    const double sharpness = std::pow(2, -16 * roughness * roughness - 1);
    return std::clamp(std::pow(n_dot_v + unoccluded, sharpness) - 1 + unoccluded, 0.0, 1.0);
}

/// Scale and bias of f0: Karis 2014, "Physically based shading on mobile".
Reflectance fitted_reflectance(double roughness, double n_dot_v) {
    const double a = 1 - roughness, b = 0.0425 - 0.0275 * roughness, c = 1.04 - 0.572 * roughness,
                 d = 0.022 * roughness - 0.04;
    const double part = std::min(a * a, std::pow(2, -9.28 * n_dot_v)) * a + b;
    return {c - 1.04 * part, d + 1.04 * part};
}

/// Of the gradient and its soft boxes.
RgbD of_gradient(const Environment& environment, const LitSurface& surface, double seen,
                 double seen_mirrored) {
    const Surface& material = surface.material;
    const double n_dot_v = glm::dot(material.normal, surface.view);
    const Reflectance fit = fitted_reflectance(material.roughness, std::clamp(n_dot_v, 0.0, 1.0));
    const RgbD around = irradiance(environment, material.normal);
    const RgbD ahead =
        radiance(environment, 2 * n_dot_v * material.normal - surface.view, material.roughness);
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        const double f0 = std::lerp(0.04, material.albedo[c], material.metalness);
        const double mirrored = std::max(f0 * fit.scale + fit.bias, 0.0);
        out[c] = seen_mirrored * mirrored * ahead[c] +
                 seen * (1 - mirrored) * (1 - material.metalness) * material.albedo[c] /
                     std::numbers::pi * around[c];
    }
    return out;
}

void add_surroundings(Lit& to, const LitSurface& surface, const Illumination& by) {
    double seen = surface.occlusion, seen_mirrored = surface.occlusion;
    if (by.has_occlusion) {
        const double n_dot_v =
            std::clamp(glm::dot(surface.material.normal, surface.view), 0.0, 1.0);
        seen *= surface.unoccluded;
        seen_mirrored *=
            mirrored_occlusion(surface.unoccluded, n_dot_v, surface.material.roughness);
    }
    if (by.maps != nullptr) {
        const Filtered found =
            reflected(*by.maps, surface.material, surface.view, seen, seen_mirrored);
        add(to, found.light, found.doubt);
    } else if (by.environment != nullptr) {
        add(to, of_gradient(*by.environment, surface, seen, seen_mirrored), {});
    }
}

/// Whether some light stands so near, or so near the surface's horizon, that it matters where
/// floats place the surface.
bool hangs_on_place(const LitSurface& surface, const Illumination& by, double rounding) {
    return std::any_of(by.lights.begin(), by.lights.end(), [&](const LightBlock& light) {
        const dvec3 towards = dvec3(light.position_layer) - surface.position;
        return !(light.range.w > 0) &&
               std::abs(glm::dot(surface.material.normal, towards)) < 1e4 * rounding;
    });
}

Lit lit_where_it_is(const LitSurface& surface, const Illumination& by) {
    Lit out;
    add(out, surface.emission, {});
    if (surface.is_unlit) {
        return out;
    }
    for (const LightBlock& light : by.lights) {
        const RgbD unshadowed =
            times(shaded(surface, light),
                  lutlib::to_double(lutlib::Rgb{light.intensity_texel.x, light.intensity_texel.y,
                                                light.intensity_texel.z}));
        if (unshadowed == RgbD{}) {
            continue;
        }
        const Arrival arriving = shadowed(surface, light, by);
        const RgbD doubt{std::abs(unshadowed.r), std::abs(unshadowed.g), std::abs(unshadowed.b)};
        add(out, unshadowed * arriving.share, doubt * arriving.doubt);
    }
    add_surroundings(out, surface, by);
    return out;
}

} // namespace

Lit lit(const LitSurface& surface, const Illumination& by, double rounding) {
    Lit out = lit_where_it_is(surface, by);
    if (surface.is_unlit || !hangs_on_place(surface, by, rounding)) {
        return out;
    }
    for (int i = 0; i < 6; ++i) {
        LitSurface moved = surface;
        moved.position[i / 2] += i % 2 == 0 ? rounding : -rounding;
        const RgbD there = lit_where_it_is(moved, by).light;
        for (std::size_t c = 0; c < 3; ++c) {
            out.doubt[c] += std::abs(there[c] - out.light[c]);
        }
    }
    return out;
}

} // namespace preview::reference
