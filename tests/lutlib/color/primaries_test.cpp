#include "lutlib/color/primaries.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

void expect_near(const Matrix3& got, const Matrix3& want, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(got.m[i][j], want.m[i][j], tolerance) << i << ' ' << j;
        }
    }
}

TEST(Primaries, give_the_published_matrices_to_xyz) {
    // ITU-R BT.709 in SMPTE RP 177's derivation, to four decimals; S-2014-004 for AP1.
    expect_near(rgb_to_xyz(rec709),
                {{{{.4124, .3576, .1805}, {.2126, .7152, .0722}, {.0193, .1192, .9505}}}}, 6e-5);
    expect_near(rgb_to_xyz(aces_ap1),
                {{{{.6624541811, .1340042065, .1561876870},
                   {.2722287168, .6740817658, .0536895174},
                   {-.0055746495, .0040607335, 1.0103391003}}}},
                1e-9);
}

TEST(Primaries, adapt_d65_to_d50_as_published) {
    // Lindbloom, "Chromatic adaptation", Bradford, whose whites are rounded otherwise.
    expect_near(bradford_adaptation(white_d65, {.34567, .35850}),
                {{{{1.0478112, .0228866, -.0501270},
                   {.0295424, .9904844, -.0170491},
                   {-.0092345, .0150436, .7521316}}}},
                3e-4);
}

TEST(Primaries, map_white_to_white_and_come_back) {
    for (const Primaries& other : {rec2020, arri_wide_gamut3, aces_ap1}) {
        const RgbD white = rgb_to_rgb(other, rec709) * RgbD{1, 1, 1};
        EXPECT_NEAR(white.r, 1, 1e-12);
        EXPECT_NEAR(white.g, 1, 1e-12);
        EXPECT_NEAR(white.b, 1, 1e-12);
        expect_near(rgb_to_rgb(other, rec709) * rgb_to_rgb(rec709, other), {}, 1e-12);
    }
}

} // namespace
} // namespace lutlib
