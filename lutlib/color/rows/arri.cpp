// ARRI: LogC3 at each exposure index, LogC4, and their gamuts.
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"

namespace lutlib {
namespace {

// "ALEXA Log C Curve, Usage in VFX" (2017-03-09), table of the parameters for linear scene
// exposure, SUP 3.x and later; 0.18 is mid grey at every index. The last three columns of a row
// are the line below the cut.
constexpr LogLine logc3(double cut, double b, double c, double d, double e, double f) {
    return {.cut = cut, .a = 5.555556, .b = b, .c = c * per_log10, .d = d, .e = e, .f = f};
}
constexpr LogLine ei160 = logc3(0.005561, 0.080216, 0.269036, 0.381991, 5.842037, 0.092778);
constexpr LogLine ei200 = logc3(0.006208, 0.076621, 0.266007, 0.382478, 5.776265, 0.092782);
constexpr LogLine ei250 = logc3(0.006871, 0.072941, 0.262978, 0.382966, 5.710494, 0.092786);
constexpr LogLine ei320 = logc3(0.007622, 0.068768, 0.259627, 0.383508, 5.637732, 0.092791);
constexpr LogLine ei400 = logc3(0.008318, 0.064901, 0.256598, 0.383999, 5.571960, 0.092795);
constexpr LogLine ei500 = logc3(0.009031, 0.060939, 0.253569, 0.384493, 5.506188, 0.092800);
constexpr LogLine ei640 = logc3(0.009840, 0.056443, 0.250219, 0.385040, 5.433426, 0.092805);
constexpr LogLine ei800 = logc3(0.010591, 0.052272, 0.247190, 0.385537, 5.367655, 0.092809);
constexpr LogLine ei1000 = logc3(0.011361, 0.047996, 0.244161, 0.386036, 5.301883, 0.092814);
constexpr LogLine ei1280 = logc3(0.012235, 0.043137, 0.240810, 0.386590, 5.229121, 0.092819);
constexpr LogLine ei1600 = logc3(0.013047, 0.038625, 0.237781, 0.387093, 5.163350, 0.092824);

template <const LogLine& p>
constexpr TransferCurve logc3_curve(std::string_view name, std::string_view label) {
    return log_line_curve<p>(name, label, "ARRI, ALEXA Log C Curve, Usage in VFX (2017)",
                             &gamut::arri_wide_gamut3);
}

// "ARRI LogC4 Logarithmic Color Space Specification" (2022-05-01), 4: a = (2^18 - 16) / 117.45,
// b = (1023 - 95) / 1023, c = 95 / 1023; code = (log2(a light + 64) - 6) b / 14 + c, below
// t = (2^(6 - 14 c / b) - 64) / a the line (light - t) / s, s = 7 ln 2 2^(7 - 14 c / b) / (a b).
constexpr double a = 262128 / 117.45, b = 928.0 / 1023, c = 95.0 / 1023;
constexpr double s = 0.1135972086105891, t = -0.01805699611991131;
constexpr LogLine logc4{.cut = t,
                        .a = a,
                        .b = 64,
                        .c = b / 14 * per_log2,
                        .d = c - 6 * b / 14,
                        .e = 1 / s,
                        .f = -t / s};

} // namespace

constinit const Gamut gamut::arri_wide_gamut3{
    .name = "awg3",
    .label = "ARRI Wide Gamut 3",
    .source = "ARRI, ALEXA Log C Curve, Usage in VFX (2017)",
    .primaries = {{.6840, .3130}, {.2210, .8480}, {.0861, -.1020}, white_d65}};

constinit const Gamut gamut::arri_wide_gamut4{
    .name = "awg4",
    .label = "ARRI Wide Gamut 4",
    .source = "ARRI LogC4 Logarithmic Color Space Specification (2022)",
    .primaries = {{.7347, .2653}, {.1424, .8576}, {.0991, -.0308}, white_d65}};

constinit const TransferCurve curve::logc3 = logc3_curve<ei800>("logc3", "ARRI LogC3, EI 800");
constinit const TransferCurve curve::logc3_ei160 =
    logc3_curve<ei160>("logc3-ei160", "ARRI LogC3, EI 160");
constinit const TransferCurve curve::logc3_ei200 =
    logc3_curve<ei200>("logc3-ei200", "ARRI LogC3, EI 200");
constinit const TransferCurve curve::logc3_ei250 =
    logc3_curve<ei250>("logc3-ei250", "ARRI LogC3, EI 250");
constinit const TransferCurve curve::logc3_ei320 =
    logc3_curve<ei320>("logc3-ei320", "ARRI LogC3, EI 320");
constinit const TransferCurve curve::logc3_ei400 =
    logc3_curve<ei400>("logc3-ei400", "ARRI LogC3, EI 400");
constinit const TransferCurve curve::logc3_ei500 =
    logc3_curve<ei500>("logc3-ei500", "ARRI LogC3, EI 500");
constinit const TransferCurve curve::logc3_ei640 =
    logc3_curve<ei640>("logc3-ei640", "ARRI LogC3, EI 640");
constinit const TransferCurve curve::logc3_ei1000 =
    logc3_curve<ei1000>("logc3-ei1000", "ARRI LogC3, EI 1000");
constinit const TransferCurve curve::logc3_ei1280 =
    logc3_curve<ei1280>("logc3-ei1280", "ARRI LogC3, EI 1280");
constinit const TransferCurve curve::logc3_ei1600 =
    logc3_curve<ei1600>("logc3-ei1600", "ARRI LogC3, EI 1600");

constinit const TransferCurve curve::logc4 = log_line_curve<lutlib::logc4>(
    "logc4", "ARRI LogC4", "ARRI LogC4 Logarithmic Color Space Specification (2022)",
    &gamut::arri_wide_gamut4);

} // namespace lutlib
