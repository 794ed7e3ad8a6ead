// The shape that most camera curves share: a logarithm above a cut, a straight line below it.
#pragma once

#include "lutlib/color/powers.h"
#include "lutlib/color/transfer_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lutlib {

/// code = c ln(a light + b) + d from `cut` on, e light + f below it.
///
/// Makers round their constants, so the two parts meet only nearly. Each stops at the code of the
/// cut as the logarithm has it, which keeps the curve rising: light or codes within the gap (below
/// 2e-5 and 2e-4) become the cut's. The line goes on below black for ever; light stops at
/// largest_light.
struct LogLine {
    double cut, a, b, c, d, e, f;

    double code_of(double light) const { return c * std::log(a * light + b) + d; }
};

/// For constants that makers give for other logarithms.
inline constexpr double per_log10 = 1 / std::numbers::ln10, per_log2 = 1 / std::numbers::ln2;

template <const LogLine& p>
double log_line_decode(double code) {
    if (code < p.code_of(p.cut)) {
        return std::min((code - p.f) / p.e, p.cut);
    }
    return std::clamp((std::exp((code - p.d) / p.c) - p.b) / p.a, p.cut, largest_light);
}

template <const LogLine& p>
double log_line_encode(double light) {
    const double code_cut = p.code_of(p.cut);
    return light < p.cut ? std::min(p.e * light + p.f, code_cut)
                         : std::max(p.code_of(std::min(light, largest_light)), code_cut);
}

/// Runs curve(x, t) on all channels in pieces that stay in the first-level cache; t is room for as
/// many intermediate numbers.
template <class F>
void each_piece(std::span<RgbD> colors, F curve) {
    static_assert(sizeof(RgbD) == 3 * sizeof(double));
    constexpr std::size_t piece = 384;
    std::array<double, piece> room;
    double* const first = colors.empty() ? nullptr : &colors.front().r;
    const std::size_t count = 3 * colors.size();
    for (std::size_t i = 0; i < count; i += piece) {
        const std::size_t n = std::min(piece, count - i);
        curve(std::span(first + i, n), std::span(room).first(n));
    }
}

void log_line_decode_all(const LogLine& p, std::span<RgbD> colors);
void log_line_encode_all(const LogLine& p, std::span<RgbD> colors);

template <const LogLine& p>
constexpr TransferCurve log_line_curve(std::string_view name, std::string_view label,
                                       std::string_view source, const Gamut* gamut) {
    return {.name = name,
            .label = label,
            .source = source,
            .gamut = gamut,
            .brightest = largest_light,
            .decode = log_line_decode<p>,
            .encode = log_line_encode<p>,
            .decode_all = [](std::span<RgbD> colors) { log_line_decode_all(p, colors); },
            .encode_all = [](std::span<RgbD> colors) { log_line_encode_all(p, colors); }};
}

} // namespace lutlib
