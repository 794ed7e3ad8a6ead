#include "lutlib/survey/stiff_function.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr double pi = 3.14159265358979323846;

double logistic(double x) {
    return 1 / (1 + std::exp(-x));
}

double power_above(double t, double place, double exponent) {
    return t > place ? std::pow(t - place, exponent) : 0;
}

double hat(double distance, double width) {
    return std::max(0.0, 1 - std::abs(distance) / width);
}

// A lift of one colour by the width of a 65-node lattice's cell.
RgbD spike(RgbD c, double place) {
    constexpr double width = 1.0 / 64;
    const double lift = hat(c.r - place, width) * hat(c.g - place, width) * hat(c.b - place, width);
    return 0.5 * (c + RgbD{lift, lift, lift});
}

// What is strongly saturated becomes more so, within a thin shell around the neutral axis.
RgbD shell(RgbD c, double place) {
    constexpr double width = 0.03;
    const double most = std::max({c.r, c.g, c.b}), least = std::min({c.r, c.g, c.b});
    const double middle = (most + least) / 2;
    const double x = (most - least - place) / width;
    const double more = 0.5 * std::exp(-x * x);
    return RgbD{0.25, 0.25, 0.25} + 0.5 * (c + more * (c - RgbD{middle, middle, middle}));
}

constexpr std::array<StiffProfile, 13> stiff_profile_rows{{
    {"smooth", "half a cosine wave, for comparison", 0, 2,
     [](double t, double p) { return 0.5 - 0.5 * std::cos(pi * (t - p)); }, nullptr},
    {"shoulder", "a film's shoulder, turned up: logistic of slope 50", 0.5, -1,
     [](double t, double p) { return logistic(200 * (t - p)); }, nullptr},
    {"kink", "a bend: 0 below the middle, then of slope 2", 0.5, 1,
     [](double t, double p) { return 2 * std::max(0.0, t - p); }, nullptr},
    {"plateau", "rising to 1, then flat: clipped highlights", 0.75, 1,
     [](double t, double p) { return std::min(1.0, t / p); }, nullptr},
    {"fold", "rising to 1 and falling again", 0.5, 1,
     [](double t, double p) { return 1 - 1.5 * std::abs(t - p); }, nullptr},
    {"cusp", "the root of the distance from the middle", 0.5, 0.5,
     [](double t, double p) { return std::sqrt(2 * std::abs(t - p)); }, nullptr},
    {"gamma_2.2", "the power 1/2.2 from black", 0, 1 / 2.2,
     [](double t, double p) { return power_above(t, p, 1 / 2.2); }, nullptr},
    {"gamma_10", "the power 1/10 from black", 0, 0.1,
     [](double t, double p) { return power_above(t, p, 0.1); }, nullptr},
    {"gain_1000", "times 1000 about the middle, clipped to 0..1", 0.5, -1,
     [](double t, double p) { return saturate(1000 * (t - p) + 0.5); }, nullptr},
    {"step", "0 below the middle, else 1", 0.5, 0,
     [](double t, double p) { return t < p ? 0.0 : 1.0; }, nullptr},
    {"posterised", "four steps", 0.5, 0,
     [](double t, double p) { return saturate((std::floor((t - p) * 4) + 2) / 4); }, nullptr},
    {"spike", "one colour lifted, as wide as a node of 65", 0.5, -1, nullptr, spike},
    {"shell", "a thin shell of saturated colours, more saturated", 0.7, -1, nullptr, shell},
}};

// Of a mean: the weights of each output, turned from one to the next.
constexpr std::array<double, 3> weights{0.6, 0.3, 0.1};
constexpr double fine = 1e-4;

} // namespace

std::span<const StiffProfile> stiff_profiles() {
    return stiff_profile_rows;
}

double StiffFunction::argument(RgbD c, std::size_t channel) const {
    return axis == StiffAxis::channel
               ? c[channel]
               : weights[0] * c[channel] + weights[1] * c[(channel + 1) % 3] +
                     weights[2] * c[(channel + 2) % 3];
}

RgbD StiffFunction::operator()(RgbD c) const {
    if (profile->of_color) {
        return profile->of_color(c, place);
    }
    return {profile->at(argument(c, 0), place), profile->at(argument(c, 1), place),
            profile->at(argument(c, 2), place)};
}

RgbD StiffFunction::with_argument(RgbD c, double t) const {
    if (axis == StiffAxis::channel) {
        c.r = saturate(t);
        return c;
    }
    // Towards black or towards white, which stays within 0..1 and turns no weight negative.
    const double here = argument(c, 0), wanted = saturate(t);
    if (wanted <= here) {
        return here > 0 ? (wanted / here) * c : c;
    }
    const RgbD white{1, 1, 1};
    return white - ((1 - wanted) / (1 - here)) * (white - c);
}

StiffBound::StiffBound(const StiffFunction& of) : function(&of) {
    const auto g = [&](double t) { return of.profile->at(t, of.place); };
    for (double t = fine; t < 1; t += fine) {
        const double before = g(t - fine), here = g(t), after = g(t + fine);
        slope = std::max({slope, std::abs(after - here) / fine, std::abs(here - before) / fine});
        curvature = std::max(curvature, std::abs(after - 2 * here + before) / (fine * fine));
    }
}

double StiffBound::modulus(double width) const {
    double most = 0;
    for (double t = 0; t <= 1; t += fine) {
        const double here = function->profile->at(t, function->place);
        const double there = function->profile->at(std::min(t + width, 1.0), function->place);
        most = std::max(most, std::abs(there - here));
    }
    return most;
}

double StiffBound::of_means(double h) const {
    return std::min({h * h / 8 * curvature, h / 2 * slope, modulus(h)});
}

} // namespace lutlib
