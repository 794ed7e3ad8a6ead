// ITU-R BT.2100: PQ and HLG.
#include "lutlib/color/powers.h"
#include "lutlib/color/rows/all.h"
#include "lutlib/color/rows/log_line.h"
#include "lutlib/color/transfer.h"
#include "lutlib/color/transfer_constants.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

void pq_decode_all(std::span<RgbD> colors) {
    using namespace pq;
    each_piece(colors, [](std::span<double> x, std::span<double>) {
        for (double& v : x) {
            v = std::clamp(v, 0.0, 1.0);
        }
        power_all(x, 1 / m2);
        for (double& p : x) {
            p = std::max(p - c1, 0.0) / (c2 - c3 * p);
        }
        power_all(x, 1 / m1);
        for (double& v : x) {
            v *= peak / pq_white_nits;
        }
    });
}

void pq_encode_all(std::span<RgbD> colors) {
    using namespace pq;
    each_piece(colors, [](std::span<double> x, std::span<double>) {
        for (double& v : x) {
            v = std::clamp(v * (pq_white_nits / peak), 0.0, 1.0);
        }
        power_all(x, m1);
        for (double& p : x) {
            p = (c1 + c2 * p) / (1 + c3 * p);
        }
        power_all(x, m2);
    });
}

namespace hlg {

// ITU-R BT.2100-2, table 5. The curve's own light E is 1 at code 1. Ours is 1 at code 0.75, which
// ITU-R BT.2408-4, table 1, gives to a diffuse white of 100 % reflectance, so mid grey is 0.18.
constexpr double a = 0.17883277, b = 0.28466892, c = 0.55991073;
constexpr double white = 0.26496256042100724; // E of code 0.75: (exp((0.75 - c) / a) + b) / 12

double decode(double code) {
    const double x = std::abs(code);
    const double e = x <= 0.5 ? x * x / 3 : (std::exp((x - c) / a) + b) / 12;
    return std::copysign(std::min(e / white, largest_light), code);
}

double encode(double linear) {
    const double e = white * std::min(std::abs(linear), largest_light);
    const double code = e <= 1.0 / 12 ? std::sqrt(3 * e) : a * std::log(12 * e - b) + c;
    return std::copysign(code, linear);
}

} // namespace hlg
} // namespace

/// Light of 1 is 100 cd/m2, so a code of 1 decodes to 100.
constinit const TransferCurve curve::pq{.name = "pq",
                                        .label = "PQ, 100 cd/m2 at light 1",
                                        .source = "SMPTE ST 2084:2014; ITU-R BT.2100-2, table 4",
                                        .gamut = &gamut::rec2020,
                                        .darkest = 0,
                                        .brightest = lutlib::pq::peak / pq_white_nits,
                                        .decode = pq_decode,
                                        .encode = pq_encode,
                                        .decode_all = pq_decode_all,
                                        .encode_all = pq_encode_all};

/// The scene's light, without the system gamma of a display. Odd.
constinit const TransferCurve curve::hlg{.name = "hlg",
                                         .label = "HLG, scene light, code 0.75 at light 1",
                                         .source =
                                             "ITU-R BT.2100-2, table 5; ITU-R BT.2408-4, table 1",
                                         .gamut = &gamut::rec2020,
                                         .darkest = -largest_light,
                                         .brightest = largest_light,
                                         .decode = lutlib::hlg::decode,
                                         .encode = lutlib::hlg::encode,
                                         .decode_all = each_channel<lutlib::hlg::decode>,
                                         .encode_all = each_channel<lutlib::hlg::encode>};

} // namespace lutlib
