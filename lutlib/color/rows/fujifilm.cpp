// Fujifilm: F-Log and F-Log2, whose F-Gamut is Rec.2020.
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"

namespace lutlib {
namespace {

constexpr LogLine flog{.cut = 0.00089,
                       .a = 0.555556,
                       .b = 0.009468,
                       .c = 0.344676 * per_log10,
                       .d = 0.790453,
                       .e = 8.735631,
                       .f = 0.092864};

constexpr LogLine flog2{.cut = 0.000889,
                        .a = 5.555556,
                        .b = 0.064829,
                        .c = 0.245281 * per_log10,
                        .d = 0.384316,
                        .e = 8.799461,
                        .f = 0.092864};

} // namespace

constinit const TransferCurve curve::flog = log_line_curve<lutlib::flog>(
    "flog", "Fujifilm F-Log", "Fujifilm, F-Log Data Sheet Ver.1.1 (2022)", &gamut::rec2020);

constinit const TransferCurve curve::flog2 = log_line_curve<lutlib::flog2>(
    "flog2", "Fujifilm F-Log2", "Fujifilm, F-Log2 Data Sheet Ver.1.0 (2022)", &gamut::rec2020);

} // namespace lutlib
