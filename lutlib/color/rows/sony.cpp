// Sony: S-Log2, S-Log3, and their gamuts.
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"

namespace lutlib {
namespace {

// "S-Log: A new LUT for digital production mastering and interchange applications" with S-Log2's
// 155/219 of the input (S-Log2 IDT, IDT.Sony.SLog2): of light over a white of 0.9, to codes of
// legal range, 64 to 940 of 1023.
constexpr double in = 155.0 / 219 / 0.9, out = 876.0 / 1023, black = 64.0 / 1023;
constexpr LogLine slog2{.cut = 0,
                        .a = in,
                        .b = 0.037584,
                        .c = out * 0.432699 * per_log10,
                        .d = out * (0.616596 + 0.03) + black,
                        .e = out * 5 * in,
                        .f = out * 0.030001222851889303 + black};

// "Technical Summary for S-Gamut3.Cine/S-Log3 and S-Gamut3/S-Log3", version 1.00, appendix.
constexpr LogLine slog3{.cut = 0.01125,
                        .a = 1 / 0.19,
                        .b = 0.01 / 0.19,
                        .c = 261.5 / 1023 * per_log10,
                        .d = 420.0 / 1023,
                        .e = (171.2102946929 - 95) / 0.01125 / 1023,
                        .f = 95.0 / 1023};

constexpr std::string_view summary =
    "Sony, Technical Summary for S-Gamut3.Cine/S-Log3 and S-Gamut3/S-Log3, 1.00";

} // namespace

constinit const Gamut gamut::sgamut3{
    .name = "sgamut3",
    .label = "S-Gamut3 (S-Gamut has the same primaries)",
    .source = summary,
    .primaries = {{.730, .280}, {.140, .855}, {.100, -.050}, white_d65}};

constinit const Gamut gamut::sgamut3_cine{
    .name = "sgamut3.cine",
    .label = "S-Gamut3.Cine",
    .source = summary,
    .primaries = {{.766, .275}, {.225, .800}, {.089, -.087}, white_d65}};

constinit const TransferCurve curve::slog2 = log_line_curve<lutlib::slog2>(
    "slog2", "Sony S-Log2",
    "Sony, S-Log: A new LUT for digital production mastering; IDT.Sony.SLog2", &gamut::sgamut3);

constinit const TransferCurve curve::slog3 =
    log_line_curve<lutlib::slog3>("slog3", "Sony S-Log3", summary, &gamut::sgamut3_cine);

} // namespace lutlib
