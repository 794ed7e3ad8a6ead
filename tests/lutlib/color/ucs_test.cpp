#include "lutlib/color/ucs.h"

#include "lutlib/color/encoding.h"
#include "lutlib/metrics/viewing.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

// Of the chromaticities that ITU-R BT.709 and BT.2020 state, by u' = 4x / (-2x + 12y + 3) and
// v' = 9y / (-2x + 12y + 3).
TEST(Ucs, has_the_places_of_known_chromaticities) {
    struct Known {
        Chromaticity at;
        double u, v;
    };
    for (const Known& known : {Known{white_d65, 0.197830, 0.468320},
                               {rec709.red, 0.450704, 0.522887},
                               {rec709.green, 0.125000, 0.562500},
                               {rec709.blue, 0.175439, 0.157895},
                               {rec2020.red, 0.556604, 0.516509}}) {
        const UcsPlace place = ucs_of(known.at);
        EXPECT_NEAR(place.u, known.u, 1e-6);
        EXPECT_NEAR(place.v, known.v, 1e-6);
        // Luminance changes neither.
        const UcsPlace darker = ucs_of(xyz_of(known.at) * 0.01);
        EXPECT_NEAR(darker.u, place.u, 1e-12);
        EXPECT_NEAR(darker.v, place.v, 1e-12);
    }
    EXPECT_EQ(ucs_saturation(ucs_of(white_d65), ucs_of(white_d65)), 0);
    EXPECT_NEAR(ucs_saturation({0.2, 0.5}, {0.2, 0.4}), 1.3, 1e-12);
}

TEST(LightToRec709, has_diffuse_white_at_1_in_every_encoding) {
    const auto white_of = [](const char* name, double nits, double code) {
        const Encoding encoding = *encoding_named(name);
        const double light = encoding.decode(code);
        return light_to_rec709(Viewing(encoding, nits)) * RgbD{light, light, light};
    };
    for (const RgbD& white :
         {white_of("srgb", 203, 1), white_of("srgb", 100, 1),
          // PQ says how much light it is: 203 cd/m2 are the code 0.58.
          white_of("pq", 203, 0.580688881), white_of("linear/p3-dci", 203, 1)}) {
        EXPECT_NEAR(white.r, 1, 1e-6);
        EXPECT_NEAR(white.g, 1, 1e-6);
        EXPECT_NEAR(white.b, 1, 1e-6);
    }
}

} // namespace
} // namespace lutlib
