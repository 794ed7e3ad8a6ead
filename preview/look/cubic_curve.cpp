#include "preview/look/cubic_curve.h"

#include "lutlib/color/encoding.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace preview {

namespace {

constexpr std::uint32_t piece_bits = 17; // of a float's mantissa below the 64 of an octave

/// The cubic through f at the ends and the thirds of low..high.
template <class F>
CubicCurve::Piece piece_of(F f, double low, double high) {
    std::array<double, 4> y{};
    for (std::size_t i = 0; i < y.size(); ++i) {
        y[i] = f(low + (high - low) * static_cast<double>(i) / 3);
    }
    return {static_cast<float>(y[0]),
            static_cast<float>((-11 * y[0] + 18 * y[1] - 9 * y[2] + 2 * y[3]) / 2),
            static_cast<float>((18 * y[0] - 45 * y[1] + 36 * y[2] - 9 * y[3]) / 2),
            static_cast<float>((-9 * y[0] + 27 * y[1] - 27 * y[2] + 9 * y[3]) / 2)};
}

float value_at(const CubicCurve::Piece& c, float t) {
    return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

float smallest() {
    return std::ldexp(1.0F, CubicCurve::lowest);
}

} // namespace

CubicCurve::CubicCurve(const lutlib::TransferCurve& curve) {
    const auto encode_light = [&](double light) { return curve.encode(light); };
    for (const double sign : {1.0, -1.0}) {
        encoding.push_back(piece_of(encode_light, 0, sign * std::ldexp(1.0, lowest)));
        for (int i = 0; i < octaves * octave_pieces; ++i) {
            const double octave = sign * std::ldexp(1.0, lowest + i / octave_pieces);
            const double at = static_cast<double>(i % octave_pieces) / octave_pieces;
            encoding.push_back(
                piece_of(encode_light, octave * (1 + at), octave * (1 + at + 1.0 / octave_pieces)));
        }
    }
    low = static_cast<float>(std::clamp(curve.encode(-lutlib::largest_light), -1.0, 0.0));
    high = static_cast<float>(std::clamp(curve.encode(lutlib::largest_light), 1.0, 4.0));
    const double step = (static_cast<double>(high) - static_cast<double>(low)) / code_pieces;
    for (int i = 0; i < code_pieces; ++i) {
        const double from = static_cast<double>(low) + i * step;
        decoding.push_back(
            piece_of([&](double code) { return curve.decode(code); }, from, from + step));
    }
}

float CubicCurve::encode(float light) const {
    const float size = std::min(std::abs(light), static_cast<float>(lutlib::largest_light));
    std::size_t piece = 0;
    float t = size / smallest();
    if (!(size < smallest())) {
        const std::uint32_t bits =
            std::bit_cast<std::uint32_t>(size) - std::bit_cast<std::uint32_t>(smallest());
        piece = 1 + (bits >> piece_bits);
        t = std::ldexp(static_cast<float>(bits & ((1U << piece_bits) - 1)),
                       -static_cast<int>(piece_bits));
    }
    return value_at(encoding[piece + (light < 0 ? light_pieces : 0)], t);
}

float CubicCurve::decode(float code) const {
    const float x = std::clamp((code - low) / (high - low), 0.0F, 1.0F) * code_pieces;
    const int piece = std::min(static_cast<int>(x), code_pieces - 1);
    return value_at(decoding[static_cast<std::size_t>(piece)], x - static_cast<float>(piece));
}

} // namespace preview
