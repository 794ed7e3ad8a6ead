// Panasonic: V-Log and V-Gamut.
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"

namespace lutlib {
namespace {

constexpr std::string_view manual = "Panasonic, V-Log/V-Gamut Reference Manual (2014-11-28)";

constexpr LogLine vlog{.cut = 0.01,
                       .a = 1,
                       .b = 0.00873,
                       .c = 0.241514 * per_log10,
                       .d = 0.598206,
                       .e = 5.6,
                       .f = 0.125};

} // namespace

constinit const Gamut gamut::vgamut{
    .name = "vgamut",
    .label = "V-Gamut",
    .source = manual,
    .primaries = {{.730, .280}, {.165, .840}, {.100, -.030}, white_d65}};

constinit const TransferCurve curve::vlog =
    log_line_curve<lutlib::vlog>("vlog", "Panasonic V-Log", manual, &gamut::vgamut);

} // namespace lutlib
