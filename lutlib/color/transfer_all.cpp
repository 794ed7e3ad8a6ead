#include "lutlib/color/transfer_all.h"

#include "lutlib/color/powers.h"
#include "lutlib/color/transfer_constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lutlib {
namespace {

// Runs `curve` on the channels in pieces that stay in the first-level cache, with room for as many
// intermediate numbers: curve(x, t) replaces x.
template <class F>
void each_piece(std::span<RgbD> colours, F curve) {
    static_assert(sizeof(RgbD) == 3 * sizeof(double));
    constexpr std::size_t piece = 384;
    std::array<double, piece> room;
    double* const first = colours.empty() ? nullptr : &colours.front().r;
    const std::size_t count = 3 * colours.size();
    for (std::size_t i = 0; i < count; i += piece) {
        const std::size_t n = std::min(piece, count - i);
        curve(std::span(first + i, n), std::span(room).first(n));
    }
}

template <class F>
void map(std::span<const double> from, std::span<double> to, F f) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        to[i] = f(from[i]);
    }
}

// x becomes f(x, t).
template <class F>
void merge(std::span<double> x, std::span<const double> t, F f) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = f(x[i], t[i]);
    }
}

} // namespace

void srgb_decode_all(std::span<RgbD> colours) {
    each_piece(colours, [](std::span<double> x, std::span<double> t) {
        map(x, t, [](double v) { return (std::abs(v) + 0.055) / 1.055; });
        power_all(t, 2.4);
        merge(x, t, [](double v, double p) {
            return std::copysign(std::abs(v) <= 0.04045 ? std::abs(v) / 12.92 : p, v);
        });
    });
}

void srgb_encode_all(std::span<RgbD> colours) {
    each_piece(colours, [](std::span<double> x, std::span<double> t) {
        std::copy(x.begin(), x.end(), t.begin());
        power_all(t, 1 / 2.4);
        merge(x, t, [](double v, double p) {
            const double a = std::abs(v);
            return std::copysign(a <= 0.0031308 ? a * 12.92 : 1.055 * p - 0.055, v);
        });
    });
}

void gamma24_decode_all(std::span<RgbD> colours) {
    power_all(colours, {2.4, 2.4, 2.4}, Negative::mirrored);
}

void gamma24_encode_all(std::span<RgbD> colours) {
    power_all(colours, {1 / 2.4, 1 / 2.4, 1 / 2.4}, Negative::mirrored);
}

void logc3_decode_all(std::span<RgbD> colours) {
    using namespace logc3;
    each_piece(colours, [](std::span<double> x, std::span<double> t) {
        map(x, t, [](double v) { return (v - d) / c * std::numbers::ln10; });
        exp_all(t);
        merge(x, t, [](double v, double p) {
            return v <= e * cut + f ? (v - f) / e : std::min((p - b) / a, largest_light);
        });
    });
}

void logc3_encode_all(std::span<RgbD> colours) {
    using namespace logc3;
    each_piece(colours, [](std::span<double> x, std::span<double> t) {
        map(x, t, [](double v) { return a * std::clamp(v, 0.0, largest_light) + b; });
        log_all(t);
        merge(x, t, [](double v, double p) {
            return v > cut ? c / std::numbers::ln10 * p + d : e * v + f;
        });
    });
}

void acescct_decode_all(std::span<RgbD> colours) {
    using namespace acescct;
    each_piece(colours, [](std::span<double> x, std::span<double> t) {
        map(x, t, [](double v) { return (v * stops - lowest) * std::numbers::ln2; });
        exp_all(t);
        merge(x, t, [](double v, double p) {
            return v <= code_cut ? (v - offset) / slope : std::min(p, largest_light);
        });
    });
}

void acescct_encode_all(std::span<RgbD> colours) {
    using namespace acescct;
    each_piece(colours, [](std::span<double> x, std::span<double> t) {
        map(x, t, [](double v) { return std::clamp(v, light_cut, largest_light); });
        log_all(t);
        merge(x, t, [](double v, double p) {
            return v <= light_cut ? slope * v + offset : (p / std::numbers::ln2 + lowest) / stops;
        });
    });
}

void pq_decode_all(std::span<RgbD> colours) {
    using namespace pq;
    each_piece(colours, [](std::span<double> x, std::span<double>) {
        map(x, x, [](double v) { return std::clamp(v, 0.0, 1.0); });
        power_all(x, 1 / m2);
        map(x, x, [](double p) { return std::max(p - c1, 0.0) / (c2 - c3 * p); });
        power_all(x, 1 / m1);
        map(x, x, [](double v) { return peak / pq_white_nits * v; });
    });
}

void pq_encode_all(std::span<RgbD> colours) {
    using namespace pq;
    each_piece(colours, [](std::span<double> x, std::span<double>) {
        map(x, x, [](double v) { return std::clamp(v * (pq_white_nits / peak), 0.0, 1.0); });
        power_all(x, m1);
        map(x, x, [](double p) { return (c1 + c2 * p) / (1 + c3 * p); });
        power_all(x, m2);
    });
}

} // namespace lutlib
