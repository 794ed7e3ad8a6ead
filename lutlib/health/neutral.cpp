// The neutral axis: whether it rises, how its codes band, and what noise near black becomes.
#include "lutlib/color/luma.h"
#include "lutlib/health/parts.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/metrics/viewing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace lutlib::health {
namespace {

constexpr int even_points = 1025;
constexpr int eight_bits = 255, ten_bits = 1023;
// The darkest sixteenth of the axis, in input codes.
constexpr int dark_codes = 16;

// A share of the domain's width, on the neutral axis.
RgbD neutral(const Domain& d, double t) {
    return {std::lerp(static_cast<double>(d.min.r), static_cast<double>(d.max.r), t),
            std::lerp(static_cast<double>(d.min.g), static_cast<double>(d.max.g), t),
            std::lerp(static_cast<double>(d.min.b), static_cast<double>(d.max.b), t)};
}

// Between its breakpoints the look is a straight line along the axis. A shaper's breaks are its
// entries; where it bends what the cube breaks, the even points stand in.
std::vector<double> breakpoints(const Lut& lut) {
    std::vector<double> out;
    const auto even = [&out](int count) {
        for (int i = 0; i < count; ++i) {
            out.push_back(i / (count - 1.0));
        }
    };
    even(even_points);
    even(lut.shaper ? lut.shaper->size() : lut.cube ? lut.cube->size : 2);
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

namespace {

// How a neutral ramp of all codes steps, at alignments of which none lets a step hide between two
// codes.
void examine_ramp(const Lut& lut, const Codes& codes, NeutralHealth& out) {
    constexpr int phases = 4;
    const int last_code =
        codes.display_input && codes.results == Results::display ? eight_bits : ten_bits;
    out.ramp_bits = last_code == eight_bits ? 8 : 10;
    const Eye eye{Viewing(codes.output)};
    const Metric metric =
        codes.results == Results::hdr ? Metric::delta_e_itp : Metric::delta_e_2000;
    for (int phase = 0; phase < phases; ++phase) {
        std::vector<RgbD> inputs, outputs;
        for (int code = 0; code <= last_code; ++code) {
            const double t =
                std::min((code + phase / static_cast<double>(phases)) / last_code, 1.0);
            inputs.push_back(neutral(lut.domain(), t));
            outputs.push_back(evaluate_exact(lut, inputs.back()));
        }
        for (std::size_t i = 1; i < inputs.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double jump = std::abs(outputs[i][c] - outputs[i - 1][c]) * last_code;
                if (jump > out.banding_neutral.value) {
                    out.banding_neutral = {jump, to_float(inputs[i])};
                }
            }
        }
        if (codes.results == Results::scene) {
            continue;
        }
        // A display shows no more than its codes.
        for (RgbD& c : outputs) {
            c = saturate(c);
        }
        std::vector<double> steps(outputs.size() - 1);
        eye(metric, std::span(outputs).subspan(1), std::span(outputs).first(steps.size()), steps);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (std::isfinite(steps[i]) && steps[i] > out.banding_to_eye.value) {
                out.banding_to_eye = {steps[i], to_float(inputs[i + 1])};
            }
        }
    }
}

} // namespace

NeutralHealth examine_neutrals(const Lut& lut, const Codes& codes, double rounding) {
    NeutralHealth out;
    RgbD highest{-INFINITY, -INFINITY, -INFINITY};
    double highest_luma = -INFINITY, first_luma = 0;
    bool first = true;
    for (const double t : breakpoints(lut)) {
        const RgbD in = neutral(lut.domain(), t);
        const RgbD value = evaluate_exact(lut, in);
        if (!std::isfinite(largest_magnitude(value))) {
            continue;
        }
        const double y = luma(value);
        first_luma = first ? y : first_luma;
        first = false;
        out.neutral_rise = y - first_luma;
        const auto fall = [&](double now, double& high, Extreme& most) {
            if (high - now > std::max(rounding, most.value)) {
                most = {high - now, to_float(in)};
            }
            high = std::max(high, now);
        };
        fall(y, highest_luma, out.neutral_fall);
        for (std::size_t c = 0; c < 3; ++c) {
            fall(value[c], highest[c], out.channel_fall[c]);
        }
    }
    examine_ramp(lut, codes, out);
    return out;
}

Extreme examine_black(const Lut& lut) {
    Extreme out;
    const Domain& d = lut.domain();
    constexpr double half_code = 0.5 / eight_bits;
    for (int k = 1; k <= dark_codes; ++k) {
        const RgbD in = neutral(d, k / static_cast<double>(eight_bits));
        RgbD square;
        for (std::size_t a = 0; a < 3; ++a) {
            const double shift =
                half_code * (static_cast<double>(d.max[a]) - static_cast<double>(d.min[a]));
            RgbD up = in, down = in;
            up[a] += shift;
            down[a] -= shift;
            const RgbD slope =
                (1 / (2 * half_code)) * (evaluate_exact(lut, up) - evaluate_exact(lut, down));
            for (std::size_t c = 0; c < 3; ++c) {
                square[c] += slope[c] * slope[c];
            }
        }
        for (std::size_t c = 0; c < 3; ++c) {
            if (std::sqrt(square[c]) > out.value) {
                out = {std::sqrt(square[c]), to_float(in)};
            }
        }
    }
    return out;
}

} // namespace lutlib::health
