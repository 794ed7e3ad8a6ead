#include "lutlib/metrics/samples.h"

#include <cmath>

namespace lutlib {
namespace {

// Roberts's R3: multiples of the powers of the reciprocal of the real root of x^4 = x + 1.
constexpr double r3_root = 1.22074408460575947536;

void append_lattice(std::vector<Rgb>& out, int count, double offset, double step) {
    for (int b = 0; b < count; ++b) {
        for (int g = 0; g < count; ++g) {
            for (int r = 0; r < count; ++r) {
                out.push_back(
                    to_float({(r + offset) * step, (g + offset) * step, (b + offset) * step}));
            }
        }
    }
}

} // namespace

std::vector<Rgb> sample_colors(int lattice_size, const SampleCounts& counts) {
    std::vector<Rgb> out;
    append_lattice(out, 2, 0, 1);
    for (int i = 0; i < counts.neutral; ++i) {
        const float v = static_cast<float>(i) / static_cast<float>(counts.neutral - 1);
        out.push_back({v, v, v});
    }
    if (counts.lattice) {
        append_lattice(out, lattice_size, 0, 1.0 / (lattice_size - 1));
        append_lattice(out, lattice_size - 1, 0.5, 1.0 / (lattice_size - 1));
    }
    const RgbD step{1 / r3_root, 1 / (r3_root * r3_root), 1 / (r3_root * r3_root * r3_root)};
    RgbD point = RgbD{0.5, 0.5, 0.5} + step * static_cast<double>(counts.skipped);
    for (int i = 0; i < counts.random; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            point[c] += step[c];
            point[c] -= std::floor(point[c]);
        }
        out.push_back(to_float(point));
    }
    return out;
}

std::vector<Rgb> over_domain(std::vector<Rgb> colors, const Domain& domain) {
    for (Rgb& c : colors) {
        for (std::size_t i = 0; i < 3; ++i) {
            c[i] = std::lerp(domain.min[i], domain.max[i], c[i]);
        }
    }
    return colors;
}

} // namespace lutlib
