// RED: Log3G10 and REDWideGamutRGB.
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"

namespace lutlib {
namespace {

constexpr std::string_view paper =
    "RED, White Paper on REDWideGamutRGB and Log3G10, 915-0187 Rev-C (2017)";

constexpr double gain = 155.975327, shift = 0.01;
constexpr LogLine log3g10{.cut = -shift,
                          .a = gain,
                          .b = gain * shift + 1,
                          .c = 0.224282 * per_log10,
                          .d = 0,
                          .e = 15.1927,
                          .f = 15.1927 * shift};

} // namespace

constinit const Gamut gamut::red_wide_gamut{
    .name = "redwidegamutrgb",
    .label = "REDWideGamutRGB",
    .source = paper,
    .primaries = {{.780308, .304253}, {.121595, 1.493994}, {.095612, -.084589}, white_d65}};

constinit const TransferCurve curve::log3g10 =
    log_line_curve<lutlib::log3g10>("log3g10", "RED Log3G10", paper, &gamut::red_wide_gamut);

} // namespace lutlib
