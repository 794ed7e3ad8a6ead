// What displays show, and linear light itself. Every curve is an odd function (a negative code is
// the negative light), so that a wide-gamut colour survives the round trip, and has no end.
#include "lutlib/color/display_curve.h"
#include "lutlib/color/powers.h"
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"
#include "lutlib/color/transfer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

void srgb_decode_all(std::span<RgbD> colors) {
    each_piece(colors, [](std::span<double> x, std::span<double> t) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            t[i] = (std::abs(x[i]) + 0.055) / 1.055;
        }
        power_all(t, 2.4);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double a = std::abs(x[i]);
            x[i] = std::copysign(a <= 0.04045 ? a / 12.92 : t[i], x[i]);
        }
    });
}

void srgb_encode_all(std::span<RgbD> colors) {
    each_piece(colors, [](std::span<double> x, std::span<double> t) {
        std::copy(x.begin(), x.end(), t.begin());
        power_all(t, 1 / 2.4);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double a = std::abs(x[i]);
            x[i] = std::copysign(a <= 0.0031308 ? a * 12.92 : 1.055 * t[i] - 0.055, x[i]);
        }
    });
}

// ITU-R BT.709-6, item 1.2, with alpha and beta as the numbers that its equations define
// (ITU-R BT.2020-2, table 4, note): the rounded 1.099 and 0.018 would not rise at the cut.
constexpr double alpha = 1.09929682680944, beta = 0.018053968510807;

double rec709_decode(double code) {
    const double x = std::abs(code);
    const double linear = x < 4.5 * beta ? x / 4.5 : std::pow((x + alpha - 1) / alpha, 1 / 0.45);
    return std::copysign(linear, code);
}

double rec709_encode(double linear) {
    const double x = std::abs(linear);
    return std::copysign(x < beta ? 4.5 * x : alpha * std::pow(x, 0.45) - (alpha - 1), linear);
}

template <int tenths>
double power_decode(double code) {
    return std::copysign(std::pow(std::abs(code), tenths / 10.0), code);
}

template <int tenths>
double power_encode(double linear) {
    return std::copysign(std::pow(std::abs(linear), 10.0 / tenths), linear);
}

template <int tenths>
constexpr TransferCurve power_curve(std::string_view name, std::string_view label,
                                    std::string_view source, const Gamut* gamut) {
    return {.name = name,
            .label = label,
            .source = source,
            .gamut = gamut,
            .decode = power_decode<tenths>,
            .encode = power_encode<tenths>,
            .decode_all =
                [](std::span<RgbD> colors) {
                    constexpr double p = tenths / 10.0;
                    power_all(colors, {p, p, p}, Negative::mirrored);
                },
            .encode_all =
                [](std::span<RgbD> colors) {
                    constexpr double p = 10.0 / tenths;
                    power_all(colors, {p, p, p}, Negative::mirrored);
                }};
}

double unchanged(double x) {
    return x;
}

} // namespace

constinit const Gamut gamut::rec709{.name = "rec709",
                                    .label = "Rec.709 (sRGB)",
                                    .source = "ITU-R BT.709-6, item 1.4; IEC 61966-2-1",
                                    .primaries = lutlib::rec709};

constinit const Gamut gamut::rec2020{.name = "rec2020",
                                     .label = "Rec.2020",
                                     .source = "ITU-R BT.2020-2, table 3",
                                     .primaries = lutlib::rec2020};

constinit const Gamut gamut::p3_d65{
    .name = "p3-d65",
    .label = "P3, D65",
    .source = "SMPTE EG 432-1:2010",
    .primaries = {{.680, .320}, {.265, .690}, {.150, .060}, white_d65}};

constinit const Gamut gamut::p3_dci{
    .name = "p3-dci",
    .label = "P3, DCI white",
    .source = "SMPTE RP 431-2:2011",
    .primaries = {{.680, .320}, {.265, .690}, {.150, .060}, {.314, .351}}};

constinit const Gamut gamut::display_p3{
    .name = "display-p3",
    .label = "Display P3",
    .source = "Apple, Display P3; the primaries of P3, D65",
    .primaries = {{.680, .320}, {.265, .690}, {.150, .060}, white_d65}};

constinit const Gamut gamut::adobe_rgb{
    .name = "adobe-rgb",
    .label = "Adobe RGB (1998)",
    .source = "Adobe RGB (1998) Color Image Encoding, version 2005-05, 4.2.2",
    .primaries = {{.64, .33}, {.21, .71}, {.15, .06}, white_d65}};

constinit const TransferCurve curve::srgb{.name = "srgb",
                                          .label = "sRGB",
                                          .source = "IEC 61966-2-1",
                                          .gamut = &gamut::rec709,
                                          .decode = srgb_decode,
                                          .encode = srgb_encode,
                                          .decode_all = srgb_decode_all,
                                          .encode_all = srgb_encode_all};

constinit const TransferCurve curve::rec709{.name = "rec709",
                                            .label = "Rec.709 camera",
                                            .source = "ITU-R BT.709-6, item 1.2",
                                            .gamut = &gamut::rec709,
                                            .decode = rec709_decode,
                                            .encode = rec709_encode,
                                            .decode_all = each_channel<rec709_decode>,
                                            .encode_all = each_channel<rec709_encode>};

constinit const TransferCurve curve::gamma22 =
    power_curve<22>("gamma22", "Gamma 2.2", "a power of 2.2", &gamut::rec709);

constinit const TransferCurve curve::gamma24 = power_curve<24>(
    "gamma24", "BT.1886, gamma 2.4", "ITU-R BT.1886-0, annex 1, for black at 0", &gamut::rec709);

constinit const TransferCurve curve::gamma26 =
    power_curve<26>("gamma26", "DCI, gamma 2.6", "SMPTE RP 431-2:2011", &gamut::p3_dci);

constinit const TransferCurve curve::linear{.name = "linear",
                                            .label = "Linear light",
                                            .source = "the light itself",
                                            .gamut = &gamut::rec709,
                                            .decode = unchanged,
                                            .encode = unchanged,
                                            .decode_all = [](std::span<RgbD>) {},
                                            .encode_all = [](std::span<RgbD>) {}};

bool is_display_curve(const TransferCurve& curve) {
    constexpr std::array display{&curve::srgb, &curve::rec709, &curve::gamma22, &curve::gamma24,
                                 &curve::gamma26};
    return std::find(display.begin(), display.end(), &curve) != display.end();
}

} // namespace lutlib
