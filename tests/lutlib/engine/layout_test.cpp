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
              int across = 0;
              while (across * across < n) {
                  ++across;
              }
              return Pixel{(b % across) * n + r, (b / across) * n + g};
          },
          [](int n) {
              int across = 0;
              while (across * across < n) {
                  ++across;
              }
              return PictureSize{across * n, across * n};
          },
          {4, 16, 25, 64}}},
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
        EXPECT_EQ(GetParam().picture(n), row->second.size(n));
        for (int b = 0; b < n; ++b) {
            for (int g = 0; g < n; ++g) {
                for (int r = 0; r < n; ++r) {
                    ASSERT_EQ(GetParam().pixel(n, r, g, b), row->second.pixel(n, r, g, b));
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
                    const Pixel p = GetParam().pixel(n, r, g, b);
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
