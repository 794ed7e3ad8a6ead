#include "lutlib/verify/diagnose.h"

#include "lutlib/color/transfer.h"
#include "lutlib/verify/verify.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace lutlib {
namespace {

// The lookup's error is not what these tests are about.
constexpr SampleLimits hardly_any{.even = 8, .grid = 64, .between = 8};

// Pictures with one mistake each, made here without diagnose.cpp's table.
class Diagnosed : public testing::Test {
  protected:
    static constexpr int n = 16;
    const Engine& engine = *engine_named("unreal");
    const Transform look = test_looks()[3].transform();
    CodeImage right = bake(look, engine, n, 8).picture;

    std::string words(const CodeImage& picture) const {
        const Verification result =
            verify(picture, engine, n, look, no_breaks(), srgb(), hardly_any);
        EXPECT_GT(result.texels.wrong, 0U);
        return result.diagnosis ? result.diagnosis->words : "";
    }

    template <class F>
    CodeImage made(F&& code) const {
        CodeImage out = right;
        for (int b = 0; b < n; ++b) {
            for (int g = 0; g < n; ++g) {
                for (int r = 0; r < n; ++r) {
                    const RgbD value = code(r, g, b);
                    for (std::size_t c = 0; c < 3; ++c) {
                        out.at({b * n + r, g}, c) = static_cast<std::uint16_t>(value[c]);
                    }
                }
            }
        }
        return out;
    }

    RgbD codes(RgbD value) const {
        return {std::floor(value.r * 255 + 0.5), std::floor(value.g * 255 + 0.5),
                std::floor(value.b * 255 + 0.5)};
    }
    RgbD at(double r, double g, double b) const { return look(RgbD{r / 15, g / 15, b / 15}); }
};

TEST_F(Diagnosed, swapped_green_and_blue) {
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  return codes(at(r, b, g));
              })).find("green and blue are swapped"),
              std::string::npos);
}

TEST_F(Diagnosed, flipped) {
    EXPECT_NE(
        words(made([&](int r, int g, int b) { return codes(at(r, 15 - g, b)); })).find("flipped"),
        std::string::npos);
}

TEST_F(Diagnosed, mirrored_and_turned) {
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  return codes(at(15 - r, g, 15 - b));
              })).find("mirrored"),
              std::string::npos);
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  return codes(at(15 - r, 15 - g, 15 - b));
              })).find("turned by 180 degrees"),
              std::string::npos);
}

// A picture of the look itself, held against a table of it.
TEST_F(Diagnosed, what_a_look_was_sampled_from) {
    for (const int nodes : {5, 9}) {
        Lut table;
        table.cube = sampled(test_looks()[3].f, nodes);
        const Verification result =
            verify(right, engine, n, Transform::of(table, Interpolation::tetrahedral),
                   breaks_of(table), srgb(), hardly_any);
        ASSERT_GT(result.texels.wrong, 0U);
        ASSERT_TRUE(result.diagnosis) << nodes;
        EXPECT_NE(
            result.diagnosis->words.find("of " + std::to_string(nodes) + " nodes was sampled"),
            std::string::npos)
            << result.diagnosis->words;
    }
}

TEST_F(Diagnosed, half_texel) {
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  return codes(look({(r + 0.5) / 16, (g + 0.5) / 16, (b + 0.5) / 16}));
              })).find("half texel"),
              std::string::npos);
}

TEST_F(Diagnosed, srgb_decoded_twice) {
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  const RgbD v = at(r, g, b);
                  return codes({srgb_decode(v.r), srgb_decode(v.g), srgb_decode(v.b)});
              })).find("decoded twice"),
              std::string::npos);
}

// As a program does it that opens the picture: on the codes, which rounds twice.
TEST_F(Diagnosed, srgb_decoded_twice_on_the_codes) {
    const auto decoded = [](double code) { return std::round(255 * srgb_decode(code / 255)); };
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  const RgbD code = codes(at(r, g, b));
                  return RgbD{decoded(code.r), decoded(code.g), decoded(code.b)};
              })).find("sRGB was decoded twice"),
              std::string::npos);
}

// A lattice of 16 shares with one of 32 its corners alone, where most mistakes change little.
TEST_F(Diagnosed, nothing_by_the_nodes_of_a_look_that_are_not_among_the_pictures) {
    Breaks breaks = no_breaks();
    breaks.all = true;
    for (std::vector<double>& nodes : breaks.at) {
        nodes.clear();
        for (int i = 0; i < 32; ++i) {
            nodes.push_back(i / 31.0);
        }
    }
    const auto said_of = [&](const CodeImage& picture) {
        const Verification result = verify(picture, engine, n, look, breaks, srgb(), hardly_any);
        return result.diagnosis ? result.diagnosis->words : std::string();
    };
    const auto decoded = [](double code) { return std::round(255 * srgb_decode(code / 255)); };
    EXPECT_EQ(said_of(made([&](int r, int g, int b) {
                  const RgbD code = codes(at(r, g, b));
                  return RgbD{decoded(code.r), decoded(code.g), decoded(code.b)};
              })).find("right at the look's nodes"),
              std::string::npos);
    EXPECT_EQ(said_of(made([&](int r, int g, int b) {
                  return codes(at(r, g, b == 5 ? 9 : b == 9 ? 5 : b));
              })).find("right at the look's nodes"),
              std::string::npos);
    EXPECT_EQ(said_of(made([&](int r, int g, int b) {
                  const double dimmed = b > 1 && b < 13 ? 0.8 : 1;
                  return codes(at(r, g, b) * dimmed);
              })).find("right at the look's nodes"),
              std::string::npos);
}

TEST_F(Diagnosed, truncated_instead_of_rounded) {
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  const RgbD v = at(r, g, b);
                  return RgbD{std::floor(v.r * 255), std::floor(v.g * 255), std::floor(v.b * 255)};
              })).find("truncated instead of rounded"),
              std::string::npos);
}

TEST_F(Diagnosed, lowest_sixteen_of_thirty_three_nodes) {
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  return codes(look({r / 32.0, g / 32.0, b / 32.0}));
              })).find("wrong size: these are the lowest nodes of a lattice of 33"),
              std::string::npos);
}

TEST_F(Diagnosed, lossy_compression) {
    std::mt19937 random(1);
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  RgbD v = codes(at(r, g, b));
                  for (std::size_t c = 0; c < 3; ++c) {
                      v[c] = std::clamp(v[c] + static_cast<int>(random() % 9) - 4.0, 0.0, 255.0);
                  }
                  return v;
              })).find("lossy compression"),
              std::string::npos);
}

TEST_F(Diagnosed, single_damaged_texels) {
    CodeImage picture = right;
    picture.at({77, 3}, 1) ^= 0x40;
    EXPECT_NE(words(picture).find("single texels differ"), std::string::npos);
}

TEST_F(Diagnosed, another_look_is_not_explained_away) {
    const CodeImage other = bake(test_looks()[2].transform(), engine, n, 8).picture;
    EXPECT_EQ(words(other), "");
}

TEST_F(Diagnosed, flipped_along_red_and_blue) {
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  return codes(at(15 - r, g, b));
              })).find("flipped: red"),
              std::string::npos);
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  return codes(at(r, g, 15 - b));
              })).find("flipped: blue"),
              std::string::npos);
}

TEST_F(Diagnosed, nodes_that_stop_one_short) {
    EXPECT_NE(words(made([&](int r, int g, int b) {
                  return codes(look({r / 16.0, g / 16.0, b / 16.0}));
              })).find("one node short"),
              std::string::npos);
}

TEST_F(Diagnosed, color_at_half_resolution) {
    // What JPEG 4:2:0 does at any quality: luma stays, chroma becomes means of 2 x 2.
    CodeImage picture = right;
    for (int y = 0; y < picture.height; y += 2) {
        for (int x = 0; x < picture.width; x += 2) {
            std::array<Pixel, 4> four{{{x, y}, {x + 1, y}, {x, y + 1}, {x + 1, y + 1}}};
            const auto luma = [&](Pixel p) {
                return 0.299 * right.at(p, 0) + 0.587 * right.at(p, 1) + 0.114 * right.at(p, 2);
            };
            std::array<double, 3> chroma{};
            for (const Pixel p : four) {
                for (std::size_t c = 0; c < 3; ++c) {
                    chroma[c] += (right.at(p, c) - luma(p)) / 4;
                }
            }
            for (const Pixel p : four) {
                for (std::size_t c = 0; c < 3; ++c) {
                    picture.at(p, c) = static_cast<std::uint16_t>(
                        std::clamp(std::floor(luma(p) + chroma[c] + 0.5), 0.0, 255.0));
                }
            }
        }
    }
    EXPECT_NE(words(picture).find("lossy compression with colour at half resolution"),
              std::string::npos);
}

TEST_F(Diagnosed, no_compression_in_a_look_that_is_nearly_this_one) {
    const CodeImage other = made([&](int r, int g, int b) {
        const RgbD v = at(r, g, b);
        const double y = test_luma(v);
        return codes(
            saturate(RgbD{y + 1.05 * (v.r - y), y + 1.05 * (v.g - y), y + 1.05 * (v.b - y)}));
    });
    const Verification result = verify(other, engine, n, look, no_breaks(), srgb(), hardly_any);
    EXPECT_FALSE(result.diagnosis) << result.diagnosis->words;
    EXPECT_GT(result.nearest.explained, 0);
    EXPECT_FALSE(result.nearest.words.empty());
}

TEST_F(Diagnosed, no_compression_where_few_codes_are_off_by_one) {
    CodeImage picture = right;
    for (std::size_t i = 0; i < picture.samples.size(); i += 29) {
        picture.samples[i] = static_cast<std::uint16_t>(picture.samples[i] ^ 1);
    }
    EXPECT_EQ(words(picture), "");
}

TEST_F(Diagnosed, a_lone_wrong_code_of_a_look_that_truncation_would_leave_alone) {
    for (RgbD (*const f)(RgbD) : {+[](RgbD c) { return c; },
                                  +[](RgbD c) {
                                      return RgbD{1 - c.r, 1 - c.g, 1 - c.b};
                                  },
                                  +[](RgbD c) {
                                      return RgbD{c.g, c.b, c.r};
                                  }}) {
        CodeImage picture = bake(Transform::each(f), engine, n, 8).picture;
        --picture.at({33, 5}, 0);
        const Verification result =
            verify(picture, engine, n, Transform::each(f), no_breaks(), srgb(), hardly_any);
        ASSERT_TRUE(result.diagnosis);
        EXPECT_NE(result.diagnosis->words.find("single texels differ"), std::string::npos)
            << result.diagnosis->words;
    }
}

// Mistakes between any engine and any look.
std::string words_of(const CodeImage& picture, const Engine& engine, int n, const Transform& look) {
    const Verification result = verify(picture, engine, n, look, no_breaks(), srgb(), hardly_any);
    EXPECT_GT(result.texels.wrong, 0U);
    return result.diagnosis ? result.diagnosis->words : "";
}

TEST(Diagnose, names_the_identity_rather_than_a_way_to_round_a_look_near_it) {
    const Engine& engine = *engine_named("piccolo");
    const auto near = Transform::each([](RgbD c) { return RgbD{0.998 * c.r, c.g, c.b}; });
    const CodeImage identity = bake({}, engine, 16, 8).picture;
    EXPECT_NE(words_of(identity, engine, 16, near).find("is the identity"), std::string::npos);
}

TEST(Diagnose, says_nothing_of_bytes_in_a_black_picture_of_16_bits) {
    const Engine& engine = *engine_named("hald");
    CodeImage black = bake(Transform::each([](RgbD) { return RgbD{}; }), engine, 16, 16).picture;
    EXPECT_EQ(words_of(black, engine, 16, test_looks()[2].transform()), "");
}

TEST(Diagnose, knows_codes_of_8_bits_in_16) {
    const Engine& engine = *engine_named("hald");
    const Transform look = test_looks()[2].transform();
    const CodeImage narrow = bake(look, engine, 16, 8).picture;
    for (const int times : {257, 256}) {
        CodeImage wide = narrow;
        wide.depth.bits = 16;
        for (std::uint16_t& code : wide.samples) {
            code = static_cast<std::uint16_t>(code * times);
        }
        EXPECT_NE(words_of(wide, engine, 16, look).find("times " + std::to_string(times)),
                  std::string::npos);
    }
}

TEST(Diagnose, names_the_engine_whose_picture_has_the_same_dimensions) {
    struct Mixup {
        std::string_view made_for, taken_for;
        int size;
        std::string_view words;
    };
    constexpr std::array<Mixup, 5> table{{{"hald", "godot", 16, "a picture for HALD"},
                                          {"obs", "hald", 64, "a picture for OBS"},
                                          {"godot", "obs", 64, "a picture for Godot"},
                                          {"ocio", "unity", 16, "a picture for OpenColorIO"},
                                          {"unity", "ocio", 16, "a picture for Unity"}}};
    const Transform look = test_looks()[2].transform();
    for (const Mixup& m : table) {
        const CodeImage picture = bake(look, *engine_named(m.made_for), m.size, 8).picture;
        const std::string found = words_of(picture, *engine_named(m.taken_for), m.size, look);
        EXPECT_NE(found.find(m.words), std::string::npos) << m.made_for << ": " << found;
    }
}

TEST(Diagnose, knows_texel_centres_from_the_end_nodes_that_godot_reads) {
    const Engine& engine = *engine_named("godot");
    const Transform look = test_looks()[3].transform();
    Engine centred = engine;
    centred.node_input = [](int i, int n) { return (i + 0.5) / n; };
    const CodeImage picture = bake(look, centred, 16, 8).picture;
    EXPECT_NE(words_of(picture, engine, 16, look).find("all nodes were sampled at texel centres"),
              std::string::npos);
}

} // namespace
} // namespace lutlib
