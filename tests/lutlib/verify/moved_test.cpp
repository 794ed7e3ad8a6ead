#include "lutlib/verify/moved.h"

#include "lutlib/verify/palette.h"
#include "lutlib/verify/verify.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

constexpr SampleLimits hardly_any{.even = 8, .grid = 64, .between = 8};

// Pictures of the engines' layouts of side by side slices and of tiles.
class Moved : public testing::TestWithParam<std::string_view> {
  protected:
    static constexpr int n = 16;
    const Engine& engine = *engine_named(GetParam());
    const Layout& layout = *layout_named(engine.layout);
    const Transform look = test_looks()[2].transform();
    const CodeImage right = bake(look, engine, n, 8).picture;

    std::string words(const CodeImage& picture) const {
        const Verification result =
            verify(picture, engine, n, look, no_breaks(), srgb(), hardly_any);
        EXPECT_GT(result.texels.wrong, 0U);
        return result.diagnosis ? result.diagnosis->words : "";
    }

    // What leaves at one side comes in at the other, or is black.
    CodeImage shifted_by(int across, int down, bool around) const {
        CodeImage out = right;
        for (int y = 0; y < out.height; ++y) {
            for (int x = 0; x < out.width; ++x) {
                const Pixel from{x - across, y - down};
                const Pixel wrapped{(from.x + out.width) % out.width,
                                    (from.y + out.height) % out.height};
                for (std::size_t c = 0; c < 3; ++c) {
                    out.at({x, y}, c) =
                        around || wrapped == from ? right.at(wrapped, c) : std::uint16_t{0};
                }
            }
        }
        return out;
    }

    // Slice `of[b]` where slice b should be.
    CodeImage with_slices(const std::vector<int>& of) const {
        CodeImage out = right;
        for (int b = 0; b < n; ++b) {
            for (int g = 0; g < n; ++g) {
                for (int r = 0; r < n; ++r) {
                    for (std::size_t c = 0; c < 3; ++c) {
                        out.at(layout.pixel(n, out.width, r, g, b), c) =
                            right.at(layout.pixel(n, out.width, r, g, of[std::size_t(b)]), c);
                    }
                }
            }
        }
        return out;
    }

    template <class F>
    CodeImage each_texel(F&& f) const {
        CodeImage out = right;
        for (std::size_t i = 0; i < out.samples.size(); i += 3) {
            const std::array<std::uint16_t, 3> codes =
                f(std::array{out.samples[i], out.samples[i + 1], out.samples[i + 2]}, i / 3);
            std::copy(codes.begin(), codes.end(),
                      out.samples.begin() + static_cast<std::ptrdiff_t>(i));
        }
        return out;
    }
};
INSTANTIATE_TEST_SUITE_P(Engines, Moved, testing::Values("piccolo", "unity", "godot"),
                         [](const auto& row) { return std::string(row.param); });

TEST_P(Moved, by_rows_and_columns) {
    for (const bool around : {true, false}) {
        EXPECT_NE(words(shifted_by(1, 0, around)).find("shifted by 1 column to the right:"),
                  std::string::npos);
        EXPECT_NE(words(shifted_by(-3, 0, around)).find("shifted by 3 columns to the left:"),
                  std::string::npos);
        EXPECT_NE(words(shifted_by(0, 1, around)).find("shifted by 1 row down:"),
                  std::string::npos);
        EXPECT_NE(words(shifted_by(2, -2, around)).find("by 2 columns to the right and 2 rows up:"),
                  std::string::npos);
        EXPECT_NE(words(shifted_by(n, 0, around)).find("shifted by 16 columns to the right:"),
                  std::string::npos);
    }
}

TEST_P(Moved, not_a_picture_whose_texels_are_others) {
    EXPECT_FALSE(shifted(bake(test_looks()[1].transform(), engine, n, 8).picture, engine, n, look));
    EXPECT_FALSE(
        slices_exchanged(bake(test_looks()[1].transform(), engine, n, 8).picture, engine, n, look));
}

TEST_P(Moved, two_slices_swapped_and_several_elsewhere) {
    std::vector<int> of(n);
    for (int b = 0; b < n; ++b) {
        of[std::size_t(b)] = b;
    }
    std::swap(of[3], of[9]);
    EXPECT_NE(words(with_slices(of)).find("slices 3 and 9 of blue, counted from 0, are swapped"),
              std::string::npos);
    std::swap(of[9], of[12]);
    EXPECT_NE(words(with_slices(of))
                  .find("3 slices of blue stand in the wrong place: where slice "
                        "3 should be, counted from 0, is slice 9"),
              std::string::npos);
}

TEST_P(Moved, every_exchange_of_axes_and_of_channels) {
    struct Exchange {
        std::array<std::size_t, 3> order;
        std::string_view axes, channels;
    };
    constexpr std::array<Exchange, 5> table{
        {{{0, 2, 1}, "green and blue are swapped", "(RBG codes)"},
         {{1, 0, 2}, "red and green are swapped: red runs down", "(GRB codes)"},
         {{2, 1, 0}, "red and blue are swapped: the slices", "(BGR codes)"},
         {{1, 2, 0}, "green runs across a slice, blue down it", "(GBR codes)"},
         {{2, 0, 1}, "blue runs across a slice, red down it", "(BRG codes)"}}};
    for (const Exchange& exchange : table) {
        CodeImage axes = right;
        for (int b = 0; b < n; ++b) {
            for (int g = 0; g < n; ++g) {
                for (int r = 0; r < n; ++r) {
                    const std::array<int, 3> node{r, g, b};
                    for (std::size_t c = 0; c < 3; ++c) {
                        axes.at(layout.pixel(n, axes.width, node[exchange.order[0]],
                                             node[exchange.order[1]], node[exchange.order[2]]),
                                c) = right.at(layout.pixel(n, axes.width, r, g, b), c);
                    }
                }
            }
        }
        EXPECT_NE(words(axes).find(exchange.axes), std::string::npos) << exchange.axes;
        const CodeImage channels =
            each_texel([&](const std::array<std::uint16_t, 3>& codes, std::size_t) {
                return std::array{codes[exchange.order[0]], codes[exchange.order[1]],
                                  codes[exchange.order[2]]};
            });
        EXPECT_NE(words(channels).find(exchange.channels), std::string::npos) << exchange.channels;
    }
}

TEST_P(Moved, colors_of_a_palette_plain_and_dithered) {
    // Of each 27 nodes the one in the middle; dithered, every other texel is its neighbour's.
    for (const int dither : {0, 1}) {
        CodeImage picture = right;
        for (int b = 0; b < n; ++b) {
            for (int g = 0; g < n; ++g) {
                for (int r = 0; r < n; ++r) {
                    const int moved = dither * ((r + g + b) % 2 == 0 ? 1 : -1);
                    const auto middle = [&](int i) {
                        return std::min(std::clamp(i + moved, 0, n - 1) / 3 * 3 + 1, n - 1);
                    };
                    for (std::size_t c = 0; c < 3; ++c) {
                        picture.at(layout.pixel(n, picture.width, r, g, b), c) = right.at(
                            layout.pixel(n, picture.width, middle(r), middle(g), middle(b)), c);
                    }
                }
            }
        }
        EXPECT_NE(words(picture).find("saved with a palette, as a GIF"), std::string::npos)
            << words(picture);
    }
}

TEST_P(Moved, no_palette_in_greys_or_in_noise) {
    const CodeImage grey = each_texel([](std::array<std::uint16_t, 3> codes, std::size_t) {
        codes.fill(codes[1]);
        return codes;
    });
    EXPECT_FALSE(few_colors(grey, engine, n, look));
    const CodeImage noise = each_texel([](std::array<std::uint16_t, 3> codes, std::size_t i) {
        for (std::size_t c = 0; c < 3; ++c) {
            codes[c] = static_cast<std::uint16_t>(
                std::clamp<int>(codes[c] + static_cast<int>((7 * i + 3 * c) % 9) - 4, 0, 255));
        }
        return codes;
    });
    EXPECT_FALSE(few_colors(noise, engine, n, look));
}

} // namespace
} // namespace lutlib
