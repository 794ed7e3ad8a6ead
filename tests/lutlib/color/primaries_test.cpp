#include "lutlib/color/primaries.h"

#include "lutlib/color/gamut.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

void expect_near(const Matrix3& got, const Matrix3& want, double tolerance,
                 std::string_view of = "") {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(got.m[i][j], want.m[i][j], tolerance) << of << ' ' << i << ' ' << j;
        }
    }
}

struct Published {
    const char* gamut;
    Matrix3 to_xyz;
    double digits; ///< half of the last printed digit, or what a maker's own rounding leaves
};

// What makers print as matrices beside their chromaticities.
const Published matrices[] = {
    // ITU-R BT.709 in SMPTE RP 177's derivation.
    {"rec709", {{{{.4124, .3576, .1805}, {.2126, .7152, .0722}, {.0193, .1192, .9505}}}}, 6e-5},
    // ITU-R BT.2020-2 in SMPTE RP 177's derivation, luminance as its table 4.
    {"rec2020", {{{{.6370, .1446, .1689}, {.2627, .6780, .0593}, {.0000, .0281, 1.0610}}}}, 6e-5},
    // Adobe RGB (1998) Color Image Encoding, 4.3.5.3.
    {"adobe-rgb",
     {{{{.57667, .18556, .18823}, {.29734, .62736, .07529}, {.02703, .07069, .99134}}}},
     6e-6},
    // SMPTE ST 2065-1:2012, 4.
    {"ap0",
     {{{{.9525523959, 0, .0000936786},
        {.3439664498, .7281660966, -.0721325464},
        {0, 0, 1.0088251844}}}},
     1e-9},
    // S-2014-004.
    {"ap1",
     {{{{.6624541811, .1340042065, .1561876870},
        {.2722287168, .6740817658, .0536895174},
        {-.0055746495, .0040607335, 1.0103391003}}}},
     1e-9},
    // ARRI, ALEXA Log C Curve, Usage in VFX, whose D65 has more digits than ours.
    {"awg3",
     {{{{.638008, .214704, .097744}, {.291954, .823841, -.115795}, {.002798, -.067034, 1.153294}}}},
     1e-5},
    // ARRI LogC4 Logarithmic Color Space Specification.
    {"awg4",
     {{{{.7048583204, .1297602952, .1158373115},
        {.2545241764, .7814777327, -.0360019091},
        {0, 0, 1.0890577508}}}},
     1e-9},
    // Sony, S-Gamut3_S-Gamut3Cine_Matrix.xlsx.
    {"sgamut3",
     {{{{.7064827132, .1288010498, .1151721641},
        {.2709796708, .7866064112, -.0575860820},
        {-.0096778454, .0046000375, 1.0941355587}}}},
     1e-9},
    {"sgamut3.cine",
     {{{{.5990839208, .2489255161, .1024464902},
        {.2150758201, .8850685017, -.1001443219},
        {-.0320658495, -.0276583907, 1.1487819910}}}},
     1e-9},
    // Panasonic, V-Log/V-Gamut Reference Manual.
    {"vgamut",
     {{{{.679644, .152211, .118600},
        {.260686, .774894, -.035580},
        {-.009310, -.004612, 1.102980}}}},
     1e-6},
    // RED, 915-0187 Rev-C.
    {"redwidegamutrgb",
     {{{{.735275, .068609, .146571},
        {.286694, .842979, -.129673},
        {-.079681, -.347343, 1.516082}}}},
     1e-6},
    // Blackmagic Generation 5 Color Science.
    {"blackmagic-wide-gamut",
     {{{{.606530, .220408, .123479},
        {.267989, .832731, -.100720},
        {-.029442, -.086611, 1.204861}}}},
     1e-5},
    // DaVinci Resolve 17 Wide Gamut Intermediate.
    {"davinci-wide-gamut",
     {{{{.70062239, .14877482, .10105872},
        {.27411851, .87363190, -.14775041},
        {-.09896291, -.13789533, 1.32591599}}}},
     1e-8},
};

TEST(Primaries, give_the_matrices_that_makers_publish) {
    for (const Published& row : matrices) {
        expect_near(rgb_to_xyz(gamut_named(row.gamut)->primaries), row.to_xyz, row.digits,
                    row.gamut);
    }
}

TEST(Primaries, adapt_d65_to_d50_as_published) {
    // Lindbloom, "Chromatic adaptation", Bradford, whose whites are rounded otherwise.
    expect_near(adapted(white_d65, {.34567, .35850}),
                {{{{1.0478112, .0228866, -.0501270},
                   {.0295424, .9904844, -.0170491},
                   {-.0092345, .0150436, .7521316}}}},
                3e-4);
}

TEST(Primaries, map_white_to_white_and_come_back_in_every_gamut_and_adaptation) {
    for (const Gamut* from : gamuts()) {
        for (const Gamut* to : gamuts()) {
            for (const Adaptation* how : adaptations()) {
                const Matrix3 there = rgb_to_rgb(from->primaries, to->primaries, *how);
                const RgbD white = there * RgbD{1, 1, 1};
                EXPECT_NEAR(white.r, 1, 1e-12) << from->name << ' ' << to->name;
                EXPECT_NEAR(white.g, 1, 1e-12) << from->name << ' ' << to->name;
                EXPECT_NEAR(white.b, 1, 1e-12) << from->name << ' ' << to->name;
                expect_near(rgb_to_rgb(to->primaries, from->primaries, *how) * there, {}, 1e-11,
                            from->name);
            }
        }
    }
}

} // namespace
} // namespace lutlib
