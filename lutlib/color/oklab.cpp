#include "lutlib/color/oklab.h"

#include "lutlib/curve.h"

#include <array>
#include <numbers>

namespace lutlib {
namespace {

constexpr double degree = std::numbers::pi / 180;

constexpr Matrix3 rec709_cones = oklab_cones(rec709);
constexpr Matrix3 rec709_from_cones = inverse(rec709_cones);

double angle(RgbD lab) {
    return std::atan2(lab.b, lab.g) / degree;
}

// The dial against the Oklab angle, three turns long so that the ends' tangents cannot matter
// between -180 and 180 degrees.
Curve make_dial() {
    constexpr std::array<RgbD, 6> corners{
        {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}}};
    Knots knots;
    for (int turn = -1; turn <= 1; ++turn) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const double h = angle(oklab_from_linear(corners[i]));
            knots.push_back(
                {(h < 0 ? h + 360 : h) + 360 * turn, 60.0 * static_cast<double>(i) + 360 * turn});
        }
    }
    return Curve::open(knots);
}

const Curve& dial() {
    static const Curve curve = make_dial();
    return curve;
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
    const double h = dial()(std::atan2(b, a) / degree);
    return h < 0 ? h + 360 : h;
}

double oklab_hue(double place) {
    const double wanted = place - 360 * std::floor(place / 360);
    double low = -180, high = 540;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (dial()(middle) < wanted ? low : high) = middle;
    }
    return low < 360 ? low : low - 360;
}

} // namespace lutlib
