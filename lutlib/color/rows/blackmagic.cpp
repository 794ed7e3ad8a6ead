// Blackmagic Design: Film Generation 5, DaVinci Intermediate, and their gamuts.
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"

namespace lutlib {
namespace {

constexpr std::string_view generation5 =
    "Blackmagic Design, Blackmagic Generation 5 Color Science (2021)";
constexpr std::string_view resolve17 =
    "Blackmagic Design, DaVinci Resolve 17 Wide Gamut Intermediate (2020)";

constexpr LogLine film5{.cut = 0.005,
                        .a = 1,
                        .b = 0.005494072432257808,
                        .c = 0.08692876065491224,
                        .d = 0.5300133392291939,
                        .e = 8.283605932402494,
                        .f = 0.09246575342465753};

// (log2(x + A) + B) C above the cut, M x below it.
constexpr double c = 0.07329248;
constexpr LogLine intermediate{.cut = 0.00262409,
                               .a = 1,
                               .b = 0.0075,
                               .c = c * per_log2,
                               .d = 7 * c,
                               .e = 10.44426855,
                               .f = 0};

} // namespace

constinit const Gamut gamut::blackmagic_wide_gamut{
    .name = "blackmagic-wide-gamut",
    .label = "Blackmagic Wide Gamut, generation 5",
    .source = generation5,
    .primaries = {
        {.7177215, .3171181}, {.2280410, .8615690}, {.1005841, -.0820452}, {.3127170, .3290312}}};

constinit const Gamut gamut::davinci_wide_gamut{
    .name = "davinci-wide-gamut",
    .label = "DaVinci Wide Gamut",
    .source = resolve17,
    .primaries = {{.8000, .3130}, {.1682, .9877}, {.0790, -.1155}, white_d65}};

constinit const TransferCurve curve::blackmagic_film5 =
    log_line_curve<film5>("blackmagic-film5", "Blackmagic Film, generation 5", generation5,
                          &gamut::blackmagic_wide_gamut);

constinit const TransferCurve curve::davinci_intermediate = log_line_curve<intermediate>(
    "davinci-intermediate", "DaVinci Intermediate", resolve17, &gamut::davinci_wide_gamut);

} // namespace lutlib
