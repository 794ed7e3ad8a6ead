#include "lutlib/color/oklab.h"

#include "lutlib/curve.h"

#include <array>
#include <numbers>

namespace lutlib {
namespace {

constexpr Matrix3 rec709_cones = oklab_cones(rec709);
constexpr Matrix3 rec709_from_cones = inverse(rec709_cones);

// A stand-in for atan2 that needs no transcendental function: -2..2 instead of -pi..pi, the place
// on the square |a| + |b| = 1. It rises with the angle and has a continuous derivative by it, which
// is all that the dial needs.
double place_on_square(double a, double b) {
    const double t = b / (std::abs(a) + std::abs(b));
    return a >= 0 ? t : b >= 0 ? 2 - t : -2 - t;
}

// The dial against the place on the square, three turns long so that the ends' tangents cannot
// matter between -2 and 2.
Curve make_dial() {
    constexpr std::array<RgbD, 6> corners{
        {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}}};
    Knots knots;
    for (int turn = -1; turn <= 1; ++turn) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const RgbD lab = oklab_from_linear(corners[i]);
            const double place = place_on_square(lab.g, lab.b);
            knots.push_back({(place < 0 ? place + 4 : place) + 4 * turn,
                             60.0 * static_cast<double>(i) + 360 * turn});
        }
    }
    return Curve::open(knots);
}

const Curve& dial() {
    static const Curve curve = make_dial();
    return curve;
}

// A turn more where negative: of a tiny one rounding makes a whole turn, which is 0.
double within_turn(double degrees) {
    const double h = degrees < 0 ? degrees + 360 : degrees;
    return h < 360 ? h : 0;
}

} // namespace

RgbD oklab_from_linear(RgbD linear) {
    return oklab_from_lms(rec709_cones * linear);
}

RgbD linear_from_oklab(RgbD lab) {
    return rec709_from_cones * lms_from_oklab(lab);
}

double dial_hue(double a, double b) {
    if (a == 0 && b == 0) {
        return 0;
    }
    return within_turn(dial()(place_on_square(a, b)));
}

double oklab_hue(double place) {
    const double wanted = place - 360 * std::floor(place / 360);
    double low = -2, high = 6;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (dial()(middle) < wanted ? low : high) = middle;
    }
    // From the square back to the circle, within -2..2 or a turn later.
    const double p = low > 2 ? low - 4 : low;
    const double b = p > 1 ? 2 - p : p < -1 ? -2 - p : p;
    const double a = std::abs(p) > 1 ? std::abs(b) - 1 : 1 - std::abs(b);
    return within_turn(std::atan2(b, a) * 180 / std::numbers::pi);
}

} // namespace lutlib
