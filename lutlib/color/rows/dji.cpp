// DJI: D-Log and D-Gamut.
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"

namespace lutlib {
namespace {

constexpr std::string_view paper =
    "DJI, White Paper on D-Log and D-Gamut of DJI Cinema Color System (2017-09-29)";

constexpr LogLine dlog{.cut = 0.0078,
                       .a = 0.9892,
                       .b = 0.0108,
                       .c = 0.256663 * per_log10,
                       .d = 0.584555,
                       .e = 6.025,
                       .f = 0.0929};

} // namespace

constinit const Gamut gamut::dgamut{.name = "dgamut",
                                    .label = "DJI D-Gamut",
                                    .source = paper,
                                    .primaries = {{.71, .31}, {.21, .88}, {.09, -.08}, white_d65}};

constinit const TransferCurve curve::dlog =
    log_line_curve<lutlib::dlog>("dlog", "DJI D-Log", paper, &gamut::dgamut);

} // namespace lutlib
