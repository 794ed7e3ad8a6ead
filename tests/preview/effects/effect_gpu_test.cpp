// Every effect's shader against its twin in double.
#include "preview/reference/film.h"
#include "preview/reference/fxaa.h"
#include "preview/reference/hash.h"
#include "preview/reference/paintbrush.h"
#include "preview/reference/stylised.h"
#include "preview/reference/vignette.h"
#include "tests/preview/effects/effect_fixture.h"

namespace preview {
namespace {

using lutlib::Rgb;
using lutlib::RgbD;
using reference::Image;

/// A disc and a slope of another colour, both with some texture.
Image scene_of_edges() {
    Image picture(135, 67);
    for (int y = 0; y < 67; ++y) {
        for (int x = 0; x < 135; ++x) {
            const bool inside = (x - 60) * (x - 60) + (y - 30) * (y - 30) < 500 || 3 * y > x + 90;
            const double texture = 0.05 * ((x * 7 + y * 13) % 11) / 11.0;
            picture.at(x, y) =
                inside ? RgbD{0.9, 0.7 - texture, 0.2} : RgbD{0.1, 0.15 + texture, 0.3};
        }
    }
    return picture;
}

TEST_F(EffectTest, fxaa_equals_its_twin_in_double) {
    const Image picture = scene_of_edges();
    for (const double strength : {1.0, 0.5}) {
        const Image wanted = reference::fxaa(picture, strength);
        const auto got = run("fxaa:strength=" + std::to_string(strength), picture);
        std::size_t changed = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            changed += wanted.pixels[i] != picture.pixels[i];
        }
        EXPECT_GT(changed, 100U);
        // Comparisons that hang on a rounding may fall either way.
        EXPECT_LE(apart(got, wanted), 3 * got.size() / 1000) << strength;
    }
}

TEST_F(EffectTest, the_vignette_equals_its_twin_in_double) {
    const Image light = scene_of_edges();
    for (const double strength : {1.0, 0.3}) {
        for (const double angle : {10.0, 60.0, 150.0}) {
            const auto got = run("vignette:strength=" + std::to_string(strength) +
                                     ",angle=" + std::to_string(angle),
                                 light);
            EXPECT_EQ(apart(got, reference::vignette(light, strength, angle)), 0U)
                << strength << ' ' << angle;
        }
    }
}

TEST_F(EffectTest, the_vignette_of_two_pictures_side_by_side_is_that_of_each) {
    Image pair(60, 20), one(30, 20);
    for (RgbD& pixel : pair.pixels) {
        pixel = {0.5, 2, 8};
    }
    for (RgbD& pixel : one.pixels) {
        pixel = {0.5, 2, 8};
    }
    const auto together = run("vignette", pair, {.sides = 2});
    const auto alone = run("vignette", one);
    for (std::size_t i = 0; i < together.size(); ++i) {
        EXPECT_EQ(together[i], alone[i / 60 * 30 + i % 30]) << i;
    }
}

/// How many of the values differ.
std::size_t changed(const Image& a, const Image& b) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        out += a.pixels[i] != b.pixels[i];
    }
    return out;
}

TEST_F(EffectTest, film_grain_equals_its_twin_and_is_another_for_each_frame_of_the_film) {
    const Image picture = scene_of_edges();
    for (const bool is_colored : {false, true}) {
        // 67 rows: 30 thousandths are 2.01 texels, one grain is a texel at least.
        for (const double size : {1.5, 30.0}) {
            reference::Grain grain{0.15 * 0.8, std::max(size / 1000 * 67, 1.0), 36, is_colored};
            const Image wanted = reference::film_grain(picture, grain);
            EXPECT_GT(changed(wanted, picture), picture.pixels.size() * 9 / 10);
            const auto got = run("film-grain:strength=0.8,size=" + std::to_string(size) +
                                     ",colored=" + std::to_string(is_colored),
                                 picture, {.seconds = 1.52});
            EXPECT_EQ(apart(got, wanted), 0U) << is_colored << ' ' << size;
        }
    }
    const auto at = [&](double seconds) {
        return run("film-grain", picture, {.seconds = seconds});
    };
    EXPECT_EQ(at(1.501), at(1.539)); // both in frame 36 of 24 a second
    EXPECT_NE(at(1.501), at(1.542));
    EXPECT_NE(at(-0.01), at(0.01));
}

TEST_F(EffectTest, film_grain_has_no_mean_and_the_deviation_that_is_stated) {
    Image grey(160, 90);
    std::fill(grey.pixels.begin(), grey.pixels.end(), RgbD{0.5, 0.5, 0.5});
    for (const double size : {1.0, 40.0}) {
        double sum = 0, squares = 0;
        const auto got = run("film-grain:strength=0.5,size=" + std::to_string(size), grey);
        for (const Rgb& color : got) {
            sum += static_cast<double>(color.r) - 0.5;
            squares += std::pow(static_cast<double>(color.r) - 0.5, 2);
        }
        const auto count = static_cast<double>(got.size());
        // 14400 texels, of which thirteen share a grain of the larger: within four deviations.
        EXPECT_NEAR(sum / count, 0, size > 2 ? 0.01 : 0.0025);
        EXPECT_NEAR(std::sqrt(squares / count), 0.075, size > 2 ? 0.007 : 0.002);
    }
}

TEST_F(EffectTest, chromatic_aberration_equals_its_twin) {
    const Image light = scene_of_edges();
    for (const double corner : {3.0, 50.0}) {
        const Image wanted = reference::chromatic_aberration(light, corner / 1000 * 67);
        const auto got = run("chromatic-aberration:corner=" + std::to_string(corner), light);
        std::size_t off = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            EXPECT_EQ(got[i].g, static_cast<float>(wanted.pixels[i].g));
            // A texture unit's weights may have 8 bits.
            off += std::abs(static_cast<double>(got[i].r) - wanted.pixels[i].r) > 4e-3 ||
                   std::abs(static_cast<double>(got[i].b) - wanted.pixels[i].b) > 4e-3;
        }
        EXPECT_EQ(off, 0U) << corner;
    }
}

TEST_F(EffectTest, sharpening_equals_its_twin_and_leaves_flat_colors_alone) {
    const Image picture = scene_of_edges();
    for (const double reach : {1.0, 45.0}) {
        const Image wanted =
            reference::sharpened(picture, 0.7, std::max(static_cast<int>(reach * 0.067 + 0.5), 1));
        EXPECT_GT(changed(wanted, picture), 1000U);
        EXPECT_EQ(
            apart(run("sharpen:strength=0.7,reach=" + std::to_string(reach), picture), wanted), 0U)
            << reach;
    }
    Image flat(20, 20);
    std::fill(flat.pixels.begin(), flat.pixels.end(), RgbD{0.2, 0.5, 1});
    EXPECT_EQ(apart(run("sharpen:strength=1", flat), flat), 0U);
}

TEST_F(EffectTest, the_glitch_equals_its_twin_and_changes_from_step_to_step) {
    const Image picture = scene_of_edges();
    const Image wanted = reference::glitched(
        picture, {0.8 * 0.06 * 67, 0.8 * 0.3 * 67, 0.2 * 0.8, 0.8 * 0.5, 15, 2});
    const auto at = [&](double seconds) {
        return run("glitch:strength=0.8,shift=60,tear=300,static=0.5,line=30", picture,
                   {.seconds = seconds});
    };
    // Shifts that hang on a rounding may fall either way.
    EXPECT_LE(apart(at(1.3), wanted), 3 * picture.pixels.size() / 200);
    EXPECT_EQ(at(1.3), at(1.26));
    EXPECT_NE(at(1.3), at(1.34));
}

TEST_F(EffectTest, vaporwave_equals_its_twin_and_lays_its_board_where_no_surface_is) {
    const Image picture = scene_of_edges();
    std::vector<float> depth(picture.pixels.size(), 0.5F);
    std::vector<bool> is_background(depth.size());
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (i % 135 > 50) {
            depth[i] = 1;
            is_background[i] = true;
        }
    }
    const Image wanted =
        reference::vaporwave(picture, is_background, {0.9, 0.15 * 67, 1.5 * 0.5 + 10 - 10});
    EXPECT_EQ(
        apart(run("vaporwave:strength=0.9,field=150", picture, {.seconds = 21.5, .depth = depth}),
              wanted),
        0U);
}

TEST_F(EffectTest, pointillism_equals_its_twin) {
    const Image picture = scene_of_edges();
    for (const bool is_colored : {true, false}) {
        for (const double size : {2.0, 80.0}) {
            const Image wanted =
                reference::pointillism(picture, {0.9, std::max(size / 1000 * 67, 2.0), is_colored});
            const auto got = run("pointillism:strength=0.9,size=" + std::to_string(size) +
                                     ",colored=" + std::to_string(is_colored),
                                 picture);
            std::size_t off = 0;
            for (std::size_t i = 0; i < got.size(); ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    // The cells' means are halves.
                    off += std::abs(static_cast<double>(got[i][c]) - wanted.pixels[i][c]) > 4e-3;
                }
            }
            EXPECT_LE(off, got.size() / 100) << is_colored << ' ' << size;
        }
    }
}

TEST_F(EffectTest, pointillism_keeps_the_mean_color) {
    for (const RgbD color : {RgbD{0.9, 0.8, 0.5}, RgbD{0.3, 0.5, 0.7}, RgbD{0.05, 0.1, 0.02}}) {
        Image flat(120, 120);
        std::fill(flat.pixels.begin(), flat.pixels.end(), color);
        RgbD sum{};
        for (const Rgb& texel : run("pointillism:size=100", flat)) {
            sum = sum + lutlib::to_double(texel);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(sum[c] / 14400, color[c], 0.03);
        }
    }
}

TEST_F(EffectTest, the_paintbrush_equals_its_twin_whose_curl_is_that_of_differences) {
    Image picture(70, 40); // the twin looks at every stroke for each pixel
    const Image edges = scene_of_edges();
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 70; ++x) {
            picture.at(x, y) = edges.at(x + 20, y);
        }
    }
    for (const double size : {3.0, 100.0}) {
        const double cell = std::max(size / 1000 * 40 / (2 * reference::stroke_half_width), 2.0);
        // At 1.75 steps the noise stands at 1 + 0.84375.
        const Image wanted = reference::painted(
            picture, {0.9, cell, 1.5 * reference::stroke_half_width, 6 * cell / 40, 1.84375, 0.8});
        EXPECT_GT(changed(wanted, picture), 1000U);
        const auto got =
            run("paintbrush:strength=0.9,length=1.5,coherence=0.8,frequency=6,rate=2,size=" +
                    std::to_string(size),
                picture, {.seconds = 0.875});
        std::size_t off = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                // Strokes are kept as halves, and lie over one another by what those hold.
                off += std::abs(static_cast<double>(got[i][c]) - wanted.pixels[i][c]) > 1e-2;
            }
        }
        EXPECT_LE(off, got.size() / 50) << size;
    }
}

TEST_F(EffectTest, at_twice_the_resolution_an_effect_looks_alike) {
    // A soft picture, so that what differs is the effect.
    const auto soft = [](int scale) {
        Image out(96 * scale, 54 * scale);
        for (int y = 0; y < out.height; ++y) {
            for (int x = 0; x < out.width; ++x) {
                const double u = (x + 0.5) / out.width, v = (y + 0.5) / out.height;
                out.at(x, y) = {0.2 + 0.6 * u, 0.2 + 0.6 * v, 0.5 + 0.3 * std::sin(6 * u + 5 * v)};
            }
        }
        return out;
    };
    for (const char* use :
         {"film-grain:strength=1,size=80", "glitch:line=50,static=0", "pointillism:size=100",
          "paintbrush:size=100", "chromatic-aberration:corner=50", "sharpen:strength=1,reach=18.52",
          "vignette"}) {
        const auto small = run(use, soft(2)), large = run(use, soft(4));
        double sum = 0;
        for (std::size_t i = 0; i < small.size(); ++i) {
            const std::size_t x = i % 192, y = i / 192;
            for (std::size_t c = 0; c < 3; ++c) {
                double mean = 0;
                for (std::size_t n = 0; n < 4; ++n) {
                    mean += static_cast<double>(large[(2 * y + n / 2) * 384 + 2 * x + n % 2][c]);
                }
                sum += std::abs(static_cast<double>(small[i][c]) - mean / 4);
            }
        }
        EXPECT_LT(sum / static_cast<double>(3 * small.size()), 0.02) << use;
    }
}

TEST_F(EffectTest, of_two_pictures_side_by_side_each_has_its_own_effect) {
    Image one = scene_of_edges(), pair(2 * one.width, one.height);
    for (int y = 0; y < one.height; ++y) {
        for (int x = 0; x < one.width; ++x) {
            pair.at(x, y) = pair.at(x + one.width, y) = one.at(x, y);
        }
    }
    const std::vector<float> depth(one.pixels.size(), 1);
    const auto width = static_cast<std::size_t>(one.width);
    for (const PostEffect* effect : post_effects()) {
        if (effect->stage != Stage::after_look) {
            continue;
        }
        const auto alone = run(std::string(effect->name), one, {1, 0.5, depth});
        const auto both = run(std::string(effect->name), pair, {2, 0.5, depth});
        for (std::size_t i = 0; i < alone.size(); ++i) {
            const std::size_t at = i / width * 2 * width + i % width;
            ASSERT_EQ(both[at], alone[i]) << effect->name << ' ' << i;
            ASSERT_EQ(both[at + width], alone[i]) << effect->name << ' ' << i;
        }
    }
}

} // namespace
} // namespace preview
