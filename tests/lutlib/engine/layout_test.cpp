#include "lutlib/engine/layout.h"

#include "lutlib/error.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace lutlib {
namespace {

struct Independent {
    std::function<Pixel(int n, int r, int g, int b)> pixel;
    PictureSize (*size)(int n);
    std::vector<int> sizes;
};

// Written anew from each tool's own description, not from layout.cpp.
const std::map<std::string, Independent>& independent() {
    static const std::map<std::string, Independent> table{
        {"strip",
         {[](int n, int r, int g, int b) {
              return Pixel{n * b + r, g};
          },
          [](int n) {
              return PictureSize{n * n, n};
          },
          {2, 16, 33}}},
        {"strip-up",
         {[](int n, int r, int g, int b) {
              return Pixel{n * b + r, (n - 1) - g};
          },
          [](int n) {
              return PictureSize{n * n, n};
          },
          {2, 16, 32}}},
        {"strip-vertical",
         {[](int n, int r, int g, int b) {
              return Pixel{r, n * b + g};
          },
          [](int n) {
              return PictureSize{n, n * n};
          },
          {2, 16, 33}}},
        {"ocio",
         {[](int n, int r, int g, int b) {
              const int width = n * n <= 2048 ? n * n : 2048;
              const int at = (b * n + g) * n + r;
              return Pixel{at % width, at / width};
          },
          [](int n) {
              const int width = n * n <= 2048 ? n * n : 2048;
              return PictureSize{width, (n * n * n + width - 1) / width};
          },
          {2, 16, 32, 45, 46, 64}}},
        {"hald",
         {[](int n, int r, int g, int b) {
              int level = 0;
              while (level * level < n) {
                  ++level;
              }
              const int at = (b * n + g) * n + r, side = level * level * level;
              return Pixel{at % side, at / side};
          },
          [](int n) {
              int level = 0;
              while (level * level < n) {
                  ++level;
              }
              return PictureSize{level * n, level * n};
          },
          {4, 16, 25, 64}}},
        {"tiles",
         {[](int n, int r, int g, int b) {
              const int across = n == 32 ? 8 : n == 33 ? 11 : n == 16 ? 4 : n == 4 ? 2 : 5;
              return Pixel{(b % across) * n + r, (b / across) * n + g};
          },
          [](int n) {
              return n == 32   ? PictureSize{256, 128}
                     : n == 33 ? PictureSize{363, 99}
                     : n == 16 ? PictureSize{64, 64}
                     : n == 4  ? PictureSize{8, 8}
                               : PictureSize{125, 125};
          },
          {4, 16, 25, 32, 33}}},
    };
    return table;
}

class EveryLayout : public testing::TestWithParam<Layout> {};
INSTANTIATE_TEST_SUITE_P(Layouts, EveryLayout,
                         testing::ValuesIn(layouts().begin(), layouts().end()),
                         [](const auto& row) { return support::test_name(row.param.name); });

TEST_P(EveryLayout, puts_nodes_where_an_independent_description_says) {
    const auto row = independent().find(std::string(GetParam().name));
    ASSERT_NE(row, independent().end()) << "a new layout needs its own description here";
    for (const int n : row->second.sizes) {
        const PictureSize extent = row->second.size(n);
        EXPECT_EQ(GetParam().picture(n), extent);
        EXPECT_EQ(GetParam().lattice(extent), n);
        for (int b = 0; b < n; ++b) {
            for (int g = 0; g < n; ++g) {
                for (int r = 0; r < n; ++r) {
                    ASSERT_EQ(GetParam().pixel(n, extent.width, r, g, b),
                              row->second.pixel(n, r, g, b));
                }
            }
        }
    }
}

TEST_P(EveryLayout, gives_every_node_a_pixel_of_its_own_inside_the_picture) {
    for (int n = 2; n <= 36; ++n) {
        const auto size = GetParam().picture(n);
        if (!size) {
            continue;
        }
        std::set<std::pair<int, int>> seen;
        for (int b = 0; b < n; ++b) {
            for (int g = 0; g < n; ++g) {
                for (int r = 0; r < n; ++r) {
                    const Pixel p = GetParam().pixel(n, size->width, r, g, b);
                    EXPECT_TRUE(p.x >= 0 && p.x < size->width && p.y >= 0 && p.y < size->height);
                    seen.emplace(p.x, p.y);
                }
            }
        }
        EXPECT_EQ(seen.size(), static_cast<std::size_t>(n * n * n));
    }
}

TEST_P(EveryLayout, round_trips_a_cube) {
    Lut3D cube = identity_cube(16);
    cube.at(3, 5, 7) = {9, 8, 7};
    EXPECT_EQ(from_picture(to_picture(cube, GetParam()), GetParam(), 16), cube);
}

TEST_P(EveryLayout, refuses_a_picture_of_another_size) {
    EXPECT_THROW(from_picture(to_picture(identity_cube(16), GetParam()), GetParam(), 25), Error);
}

TEST(Tiles, are_read_from_a_grid_of_any_shape) {
    const Layout& tiles = *layout_named("tiles");
    // 24 slices of 24 x 24, six side by side and four down, then three and eight.
    for (const int across : {6, 3}) {
        Picture picture{across * 24, 24 / across * 24, {}};
        EXPECT_EQ(tiles.lattice(picture.size()), 24);
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                const int b = y / 24 * across + x / 24;
                picture.pixels.push_back({static_cast<float>(x % 24) / 23,
                                          static_cast<float>(y % 24) / 23,
                                          static_cast<float>(b) / 23});
            }
        }
        EXPECT_EQ(from_picture(picture, tiles, 24), identity_cube(24));
    }
    EXPECT_FALSE(tiles.lattice({576, 24})) << "one row of tiles is a strip";
    EXPECT_FALSE(tiles.lattice({24, 576}));
    EXPECT_FALSE(tiles.picture(17)) << "a prime number of slices has no grid";
}

TEST(StackedStrips, are_read_row_by_row) {
    const Layout& strip = *layout_named("strip");
    const Picture one = to_picture(identity_cube(4), strip);
    Picture two{one.width, 2 * one.height, one.pixels};
    for (const Rgb& pixel : one.pixels) {
        two.pixels.push_back(pixel * 0.5F);
    }
    EXPECT_EQ(from_picture(two, strip, 4, 0), identity_cube(4));
    EXPECT_EQ(from_picture(two, strip, 4, 1).at(3, 0, 3), (Rgb{0.5F, 0, 0.5F}));
}

} // namespace
} // namespace lutlib
