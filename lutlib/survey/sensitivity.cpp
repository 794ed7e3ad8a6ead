// What an input that is not exact does to the exact look.
#include "lutlib/metrics/samples.h"
#include "lutlib/survey/precision.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::array<int, 3> input_bits{8, 10, 12};
constexpr int grey_steps = 11;
constexpr int noise_draws = 512;

// Of two even numbers of 0..1, a normal one (Box and Muller, 1958).
double normal(double u, double v) {
    constexpr double pi = 3.14159265358979323846;
    return std::sqrt(-2 * std::log(std::max(u, 1e-12))) * std::cos(2 * pi * v);
}

// Three independent normal numbers each, the same on every machine.
std::vector<RgbD> normals() {
    const std::vector<Rgb> even =
        sample_colors(2, {.neutral = 2, .random = 2 * noise_draws, .lattice = false});
    std::vector<RgbD> out;
    for (std::size_t i = 10; i + 1 < even.size(); i += 2) {
        const RgbD u = to_double(even[i]), v = to_double(even[i + 1]);
        out.push_back({normal(u.r, v.g), normal(u.g, v.b), normal(u.b, v.r)});
    }
    return out;
}

double deviation(const std::vector<RgbD>& colors, std::size_t channel) {
    double mean = 0, square = 0;
    for (const RgbD& c : colors) {
        mean += c[channel] / static_cast<double>(colors.size());
    }
    for (const RgbD& c : colors) {
        square += (c[channel] - mean) * (c[channel] - mean);
    }
    return std::sqrt(square / static_cast<double>(colors.size() - 1));
}

} // namespace

std::vector<SensitivityRow> sensitivity_of(const SurveyReference& reference) {
    std::vector<SensitivityRow> out;
    const Domain& d = reference.domain;
    const std::size_t count = reference.inputs.size();
    for (const int bits : input_bits) {
        std::vector<double> worst(count), errors(count);
        for (unsigned corner = 0; corner < 8; ++corner) {
            std::vector<RgbD> moved(count);
            for (std::size_t i = 0; i < count; ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const double low = d.min[c], high = d.max[c];
                    const double half = 0.5 * (high - low) / (std::ldexp(1.0, bits) - 1);
                    moved[i][c] = std::clamp(static_cast<double>(reference.inputs[i][c]) +
                                                 (corner >> c & 1U ? half : -half),
                                             low, high);
                }
            }
            apply_in_parallel(reference.shown, moved);
            reference.delta_e(reference.expected, moved, errors);
            for (std::size_t i = 0; i < count; ++i) {
                worst[i] = std::max(worst[i], errors[i]);
            }
        }
        const auto middle = worst.begin() + static_cast<std::ptrdiff_t>(count / 2);
        std::nth_element(worst.begin(), middle, worst.end());
        const double p50 = *middle;
        out.push_back({bits, p50, error_stats(std::move(worst))});
    }
    return out;
}

std::vector<NoiseRow> noise_of(const SurveyReference& reference) {
    const Encoding& input = reference.recipe.input;
    const std::vector<RgbD> draws = normals();
    std::vector<NoiseRow> out;
    for (int i = 0; i < grey_steps; ++i) {
        const double share = static_cast<double>(i) / (grey_steps - 1);
        const double code = std::lerp(static_cast<double>(reference.domain.min.g),
                                      static_cast<double>(reference.domain.max.g), share);
        NoiseRow row;
        row.light = input.decode(code);
        if (!(row.light >= 0)) {
            continue;
        }
        const double electrons = row.light * camera_electrons;
        const double sigma = std::sqrt(electrons + camera_read_noise * camera_read_noise);
        std::vector<RgbD> noisy, results;
        for (const RgbD& draw : draws) {
            RgbD in;
            for (std::size_t c = 0; c < 3; ++c) {
                in[c] = input.encode((electrons + sigma * draw[c]) / camera_electrons);
            }
            noisy.push_back(in);
        }
        results = noisy;
        apply_in_parallel(reference.shown, results);
        for (std::size_t c = 0; c < 3; ++c) {
            row.in = std::max(row.in, deviation(noisy, c));
            row.out = std::max(row.out, deviation(results, c));
        }
        row.gain = row.in > 0 ? row.out / row.in : 0;
        const std::vector<RgbD> clean(results.size(), reference.shown(RgbD{code, code, code}));
        std::vector<double> errors(results.size());
        reference.delta_e(clean, results, errors);
        row.delta_e = error_stats(std::move(errors)).mean;
        out.push_back(row);
    }
    return out;
}

} // namespace lutlib
