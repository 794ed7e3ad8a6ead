#include "preview/report/glare.h"

#include "preview/finish/blooms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace preview::report {

namespace {

double model_encircled(const Bloom& bloom, double radius) {
    double out = 1 - static_cast<double>(bloom.strength);
    for (const BloomGaussian& one : bloom.gaussians) {
        const double turn = radius / static_cast<double>(one.sigma);
        out += static_cast<double>(bloom.strength * one.weight) * -std::expm1(-0.5 * turn * turn);
    }
    return out;
}

GlareModel compared(double field_of_view) {
    const Bloom& bloom = *bloom_named("glare");
    GlareModel out;
    out.field_of_view = field_of_view;
    for (double radius = 1; radius <= bloom_nominal_height; radius *= 1.1) {
        EncircledLight at{radius, model_encircled(bloom, radius),
                          spencer_encircled(radius * field_of_view / bloom_nominal_height)};
        const double apart = std::abs(at.model - at.measured);
        if (apart > out.largest) {
            out.largest = apart;
            out.at_radius = radius;
        }
        out.curve.push_back(at);
    }
    return out;
}

} // namespace

double spencer_encircled(double degrees) {
    // The integrals over the circle of f0 = 2.61e6 exp(-(t / 0.02)^2), f1 = 20.91 / (t + 0.02)^3
    // and f2 = 72.37 / (t + 0.02)^2, t in degrees, each by its own over the hemisphere.
    constexpr double a = 0.02, hemisphere = 90;
    const double t = std::clamp(degrees, 0.0, hemisphere);
    const auto f1 = [](double r) { return r * r / ((r + a) * (r + a)); };
    const auto f2 = [](double r) { return std::log1p(r / a) - r / (r + a); };
    const double turn = t / a;
    return 0.384 * -std::expm1(-turn * turn) + 0.478 * f1(t) / f1(hemisphere) +
           0.138 * f2(t) / f2(hemisphere);
}

GlareModel glare_model(double field_of_view) {
    GlareModel out = compared(field_of_view);
    for (double degrees = 1; degrees <= 150; degrees *= 1.02) {
        const GlareModel other = compared(degrees);
        if (out.best_field_of_view == 0 || other.largest < out.best_largest) {
            out.best_field_of_view = degrees;
            out.best_largest = other.largest;
        }
    }
    return out;
}

} // namespace preview::report
