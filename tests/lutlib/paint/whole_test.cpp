#include "lutlib/paint/whole.h"

#include "tests/lutlib/engine/rude_looks.h"
#include "tests/lutlib/paint/shots.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

const Framed framed{layout_named("strip"), 16};
constexpr Pixel placed_at{24, 40};

Picture graded_shot(const Transform& look = warm_look()) {
    Picture shot = screenshot(360, 180);
    put(shot, frame_picture(framed), placed_at);
    return graded(shot, look);
}

Wholeness of(const Picture& picture, const std::vector<float>& alpha = {}) {
    const std::vector<FoundStrip> found = find_strips(picture);
    EXPECT_EQ(found.size(), 1U);
    return found.empty() ? Wholeness{}
                         : wholeness_of(turned(picture, found[0].turn), found[0], alpha, "");
}

std::string names(const Wholeness& whole) {
    std::string out;
    for (const Harm& harm : whole.harms) {
        out += (out.empty() ? "" : " ") + harm.name;
    }
    return out;
}

TEST(Wholeness, of_a_strip_that_was_graded_alone_has_no_harm) {
    for (const Transform& look : {Transform{}, warm_look(), negative_look()}) {
        const Wholeness whole = of(graded_shot(look));
        EXPECT_EQ(names(whole), "");
        EXPECT_LT(whole.noise, 0.6);
        EXPECT_LT(whole.border_noise.value(), 0.01);
    }
}

TEST(Wholeness, names_scaling_and_cropping_with_their_figures) {
    const Wholeness small = of(scaled(graded_shot(), 0.75));
    EXPECT_EQ(names(small), "scaled");
    EXPECT_TRUE(small.is_spoilt());
    EXPECT_NE(small.harms[0].words.find("75 %"), std::string::npos) << small.harms[0].words;
    // The strip's 16 rows begin 40 below the frame's edge; the last four are cut off.
    const Picture whole = graded_shot();
    Picture cut{whole.width, placed_at.y + 40 + 12, {}};
    cut.pixels.assign(whole.pixels.begin(), whole.pixels.begin() + cut.width * cut.height);
    const Wholeness cropped = of(cut);
    EXPECT_EQ(names(cropped), "cropped");
    EXPECT_TRUE(cropped.is_spoilt());
    ASSERT_FALSE(cropped.harms.empty());
    EXPECT_NE(cropped.harms[0].words.find("0 columns and 4 rows"), std::string::npos)
        << cropped.harms[0].words;
}

TEST(Wholeness, names_blurring_and_sharpening) {
    for (const float share : {0.15F, 0.3F}) {
        EXPECT_NE(names(of(blurred(graded_shot(), share))).find("blurred"), std::string::npos);
        EXPECT_NE(names(of(blurred(graded_shot(), -share))).find("sharpened"), std::string::npos);
    }
}

TEST(Wholeness, tells_scaling_and_turning_of_soft_pictures_from_blurring) {
    struct Case {
        double scale, degrees;
        float blur;
        const char *names, *figure;
    };
    for (const Case& one :
         {Case{0.98, 0, 0, "scaled", "98.0 %"}, Case{1.02, 0, 0.15F, "scaled", "102.0 %"},
          Case{1, 1.5, 0, "turned", "1.5 degrees"}, Case{1, -0.7, 0.15F, "turned", "0.7 degrees"},
          Case{0.97, 1, 0, "scaled", "97 %"},
          Case{1, 0, 0.3F, "blurred", "lies on its other side"}}) {
        const Picture soft = one.blur > 0 ? blurred(graded_shot(), one.blur) : graded_shot();
        const Wholeness whole = of(in_codes(resampled(soft, one.scale, one.degrees)));
        std::string geometry;
        for (const Harm& harm : whole.harms) {
            if (harm.spoils && harm.name != "uneven") {
                geometry += (geometry.empty() ? "" : " ") + harm.name;
            }
        }
        EXPECT_EQ(geometry, one.names) << one.scale << ' ' << one.degrees;
        ASSERT_FALSE(whole.harms.empty());
        EXPECT_NE(whole.harms[0].words.find(one.figure), std::string::npos) << whole.harms[0].words;
    }
}

TEST(Wholeness, takes_edges_that_overshoot_for_sharpening_unless_the_file_is_lossy) {
    const Picture picture = blurred(graded_shot(), -0.08F);
    EXPECT_NE(names(of(picture)).find("sharpened"), std::string::npos) << names(of(picture));
    const FoundStrip strip = find_strips(picture).at(0);
    const Wholeness lossy = wholeness_of(picture, strip, {}, "it compresses with losses");
    EXPECT_EQ(names(lossy), "lossy");
    EXPECT_FALSE(lossy.is_spoilt());
}

TEST(Wholeness, names_what_lies_unevenly_over_the_border) {
    Picture shot = graded_shot();
    for (int y = 0; y < shot.height; ++y) {
        for (int x = 0; x < shot.width; ++x) {
            const double u = 2.0 * x / shot.width - 1, v = 2.0 * y / shot.height - 1;
            shot.at(x, y) = shot.at(x, y) * static_cast<float>(1 - 0.1 * (u * u + v * v));
        }
    }
    const Wholeness whole = of(in_codes(shot));
    EXPECT_NE(names(whole).find("uneven"), std::string::npos) << names(whole);
    EXPECT_TRUE(whole.is_spoilt());
}

TEST(Wholeness, tells_noise_from_grading_and_measures_it) {
    for (const double codes : {1.5, 3.0}) {
        const Wholeness whole = of(noisy(graded_shot(), codes));
        EXPECT_EQ(names(whole), "noise") << codes;
        EXPECT_FALSE(whole.is_spoilt());
        EXPECT_NEAR(whole.noise, codes, 0.25 * codes);
    }
}

TEST(Wholeness, knows_lossy_compression_by_the_border_that_it_spares) {
    const Wholeness whole = of(jpeg_compressed(graded_shot(), 85));
    EXPECT_NE(names(whole).find("ringing"), std::string::npos) << names(whole);
    EXPECT_FALSE(whole.is_spoilt()) << names(whole);
}

TEST(Wholeness, names_translucent_pixels) {
    const Picture shot = graded_shot();
    std::vector<float> alpha(shot.pixels.size(), 1);
    EXPECT_EQ(names(of(shot, alpha)), "");
    alpha[static_cast<std::size_t>((placed_at.y + 45) * shot.width + placed_at.x + 30)] = 0.5F;
    const Wholeness whole = of(shot, alpha);
    EXPECT_EQ(names(whole), "translucent");
    EXPECT_NE(whole.harms[0].words.find("1 pixels"), std::string::npos);
}

TEST(Conversion, is_named_where_the_look_is_nothing_else) {
    const auto harm_of = [](const Transform& look) {
        Lut3D cube = identity_cube(16);
        for (Rgb& node : cube.nodes) {
            node = to_float(saturate(look(to_double(node))));
        }
        return conversion_in(cube, 0.6 / 255);
    };
    EXPECT_EQ(harm_of({}).value().name, "neutral");
    EXPECT_FALSE(harm_of(warm_look()).has_value());
    const auto decode = [](double x) {
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    const auto linear = harm_of(Transform::each([&](RgbD c) {
        return RgbD{decode(c.r), decode(c.g), decode(c.b)};
    }));
    ASSERT_TRUE(linear.has_value());
    EXPECT_NE(linear->words.find("from sRGB"), std::string::npos) << linear->words;
}

} // namespace
} // namespace lutlib
