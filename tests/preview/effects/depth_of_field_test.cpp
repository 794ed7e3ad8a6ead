// Depth of field against its twin, which gathers by brute force, and what it must not do: lose
// light, or let what is sharp bleed.
#include "preview/reference/depth_of_field.h"
#include "preview/reference/depth_of_field_cells.h"
#include "tests/preview/effects/effect_fixture.h"

#include <cmath>

namespace preview {
namespace {

using lutlib::Rgb;
using lutlib::RgbD;
using reference::Image;

constexpr int width = 200, height = 128;
constexpr float near_plane = 0.1F;
constexpr double infinite = 1e30;

/// A picture, and how far away each pixel is.
struct Seen {
    Image light{width, height};
    std::vector<double> z = std::vector<double>(std::size_t{width} * height, infinite);

    double& z_at(int x, int y) { return z[static_cast<std::size_t>(y * width + x)]; }
};

class DepthOfFieldTest : public EffectTest {
  protected:
    /// The fixture's projection has the focal length of half a sensor's height times 2.
    static reference::ThinLens lens(double focus = 2) {
        return {.focal = 0.2, .aperture = 1.2, .sensor = 0.2, .focus = focus, .largest = 6.4};
    }
    static constexpr const char* use = "depth-of-field:aperture=1.2,sensor=200,largest=100";

    static std::vector<Rgb> focused(const Seen& seen, const std::string& more = ",focus=2") {
        Given given;
        for (const double z : seen.z) {
            given.depth.push_back(static_cast<float>(1 - static_cast<double>(near_plane) / z));
        }
        return run(use + more, seen.light, given);
    }

    static std::vector<double> radii(const Seen& seen, double focus = 2) {
        std::vector<double> out;
        for (const double z : seen.z) {
            out.push_back(reference::circle_radius(lens(focus), z, height));
        }
        return out;
    }

    static double sum_of(const Image& light) {
        double out = 0;
        for (const RgbD& pixel : light.pixels) {
            out += pixel.r + pixel.g + pixel.b;
        }
        return out;
    }
    static double sum_of(const std::vector<Rgb>& light) {
        double out = 0;
        for (const Rgb& pixel : light) {
            out += static_cast<double>(pixel.r) + static_cast<double>(pixel.g) +
                   static_cast<double>(pixel.b);
        }
        return out;
    }
    /// The mean of what differs, of the mean of what is wanted.
    static double apart_of(const std::vector<Rgb>& got, const Image& wanted) {
        double out = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                out += std::abs(static_cast<double>(got[i][c]) - wanted.pixels[i][c]);
            }
        }
        return out / sum_of(wanted);
    }
};

bool in_disc(int x, int y, int middle_x, int middle_y, int radius) {
    return (x - middle_x) * (x - middle_x) + (y - middle_y) * (y - middle_y) < radius * radius;
}

/// A near disc, one in focus and one behind, before a striped background.
Seen three_discs() {
    Seen out;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            out.light.at(x, y) =
                (x / 8 + y / 8) % 2 == 0 ? RgbD{0.5, 0.25, 0.125} : RgbD{0.125, 0.25, 0.75};
            if (in_disc(x, y, 150, 64, 24)) {
                out.light.at(x, y) = {1, 2, 1};
                out.z_at(x, y) = 4;
            }
            if (in_disc(x, y, 96, 64, 24)) {
                out.light.at(x, y) = {2, 1, 0.5};
                out.z_at(x, y) = 2;
            }
            if (in_disc(x, y, 50, 64, 24)) {
                out.light.at(x, y) = {0.5, 1, 4};
                out.z_at(x, y) = 0.8;
            }
        }
    }
    return out;
}

TEST_F(DepthOfFieldTest, is_near_to_what_a_gather_of_every_texel_makes) {
    const Seen seen = three_discs();
    const std::vector<double> circles = radii(seen);
    EXPECT_LT(circles[64 * width + 50], -5); // before the focus
    EXPECT_EQ(circles[64 * width + 96], 0);
    EXPECT_GT(circles[0], 5);
    const Image wanted = reference::focused(seen.light, circles);
    const auto got = focused(seen), finer = focused(seen, ",focus=2,cell=1"),
               coarser = focused(seen, ",focus=2,cell=4");
    std::vector<Rgb> sharp;
    for (const RgbD& pixel : seen.light.pixels) {
        sharp.push_back(lutlib::to_float(pixel));
    }
    RecordProperty("apart", std::to_string(apart_of(got, wanted)));
    EXPECT_GT(apart_of(sharp, wanted), 0.15);
    EXPECT_LT(apart_of(got, wanted), 0.03);
    EXPECT_LT(apart_of(finer, wanted), apart_of(got, wanted));
    EXPECT_GT(apart_of(coarser, wanted), apart_of(got, wanted));
    EXPECT_LT(apart_of(coarser, wanted), 0.1);
    for (const auto& light : {got, finer, coarser}) {
        EXPECT_NEAR(sum_of(light) / sum_of(wanted), 1, 0.01);
    }
}

TEST_F(DepthOfFieldTest, equals_its_twin_but_where_a_rounding_moves_a_point_to_the_next_texel) {
    const Seen seen = three_discs();
    for (const int cell : {1, 2, 3, 4}) {
        for (const int rings : {1, 3, 6}) {
            const Image wanted = reference::focused_by_cells(
                seen.light, radii(seen), {.cell = cell, .rings = rings, .largest = 6.4});
            const auto got = focused(seen, ",focus=2,cell=" + std::to_string(cell) +
                                               ",rings=" + std::to_string(rings));
            std::size_t beyond = 0;
            for (std::size_t i = 0; i < got.size(); ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const double want = wanted.pixels[i][c];
                    beyond += std::abs(static_cast<double>(got[i][c]) - want) > 0.01 * (1 + want);
                }
            }
            EXPECT_LT(beyond, got.size() / 50) << cell << ' ' << rings;
            EXPECT_LT(apart_of(got, wanted), 0.003) << cell << ' ' << rings;
            EXPECT_NEAR(sum_of(got) / sum_of(wanted), 1, 1e-3) << cell << ' ' << rings;
        }
    }
}

TEST_F(DepthOfFieldTest, keeps_the_light_of_points_before_and_behind_the_focus) {
    for (const double z : {0.8, 1.2, 3.0, 6.0, infinite}) {
        Seen seen;
        std::fill(seen.z.begin(), seen.z.end(), z);
        for (const auto& [x, y] : {std::pair{40, 41}, {101, 64}, {102, 64}, {160, 90}}) {
            seen.light.at(x, y) = {64, 512, 4096};
        }
        for (const char* cell : {"1", "2", "3", "4"}) {
            const auto got = focused(seen, std::string(",focus=2,cell=") + cell);
            EXPECT_NEAR(sum_of(got) / sum_of(seen.light), 1, 0.01) << z << ' ' << cell;
            const double most = static_cast<double>(got[41 * width + 40].b);
            EXPECT_LT(most, std::abs(radii(seen)[0]) > 2 ? 1000 : 4097) << z; // it has spread
        }
    }
}

TEST_F(DepthOfFieldTest, keeps_the_light_of_an_object_before_the_focus_over_black) {
    Seen seen;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            seen.z_at(x, y) = 2;
            if (in_disc(x, y, 100, 64, 30)) {
                seen.light.at(x, y) = {1, 2, 4};
                seen.z_at(x, y) = 0.8;
            }
        }
    }
    EXPECT_NEAR(sum_of(focused(seen)) / sum_of(seen.light), 1, 0.01);
}

TEST_F(DepthOfFieldTest,
       lets_nothing_sharp_bleed_into_what_is_blurred_behind_it_and_leaves_no_halo) {
    Seen seen;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            seen.light.at(x, y) = {0.25, 0.25, 0.25};
            if (in_disc(x, y, 101, 65, 30)) {
                seen.light.at(x, y) = {64, 0, 64};
                seen.z_at(x, y) = 2;
            }
        }
    }
    const auto got = focused(seen);
    for (std::size_t i = 0; i < got.size(); ++i) {
        const bool is_sharp = seen.z[i] < infinite;
        const double wanted = is_sharp ? 64 : 0.25;
        // A hundredth of what is 256 times as bright reaches the texels at the edge.
        ASSERT_NEAR(got[i].r, wanted, is_sharp ? 0 : 0.02) << i % width << ' ' << i / width;
        ASSERT_NEAR(got[i].g, is_sharp ? 0 : 0.25, is_sharp ? 0 : 0.005) << i;
        const double x = static_cast<double>(i % width) - 101,
                     y = static_cast<double>(i / width) - 65;
        if (std::hypot(x, y) > 33) { // beyond the texels that share two by two with it
            ASSERT_NEAR(got[i].r, 0.25, 0.25 * 0.02) << i % width << ' ' << i / width;
        }
    }
}

TEST_F(DepthOfFieldTest, at_half_the_resolution_looks_alike) {
    const Seen seen = three_discs();
    Image half(width / 2, height / 2);
    Given given;
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            RgbD sum{};
            for (int n = 0; n < 4; ++n) {
                sum = sum + seen.light.at(2 * x + n % 2, 2 * y + n / 2) * 0.25;
            }
            half.at(x, y) = sum;
            const double z = seen.z[static_cast<std::size_t>(2 * y * width + 2 * x)];
            given.depth.push_back(static_cast<float>(1 - static_cast<double>(near_plane) / z));
        }
    }
    const auto large = focused(seen), small = run(use + std::string(",focus=2"), half, given);
    Image wanted(half.width, half.height);
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            for (int n = 0; n < 4; ++n) {
                const int at = (2 * y + n / 2) * width + 2 * x + n % 2;
                wanted.at(x, y) =
                    wanted.at(x, y) + lutlib::to_double(large[static_cast<std::size_t>(at)]) * 0.25;
            }
        }
    }
    EXPECT_LT(apart_of(small, wanted), 0.05);
}

TEST_F(DepthOfFieldTest, focuses_on_what_is_at_a_point) {
    const Seen seen = three_discs();
    const std::string at_x = ",at-x=" + std::to_string(50.5 / width) + ",at-y=0.5";
    const auto by_point = focused(seen, at_x), by_distance = focused(seen, ",focus=0.8");
    for (std::size_t i = 0; i < by_point.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_NEAR(by_point[i][c], by_distance[i][c], 2e-3 * (1 + by_distance[i][c]));
        }
    }
    EXPECT_EQ(by_point[64 * width + 50].b, 4); // as sharp as it was
}

TEST(DepthOfFieldRow, is_left_out_when_its_largest_circle_is_under_half_a_pixel) {
    const PostEffect& effect = *post_effect_named("depth-of-field");
    const auto reason = [&](const std::string& text, std::uint32_t rows, float nearest = 0.1F) {
        return effect.idle_because(parse_use(text).values, {{}, 0.1F, nearest, 2.75F}, rows);
    };
    EXPECT_EQ(reason("depth-of-field:aperture=16", 720), "");
    EXPECT_EQ(reason("depth-of-field:aperture=16", 720, 10),
              "its largest circle is under half a pixel");
    EXPECT_EQ(reason("depth-of-field", 720), "");
    EXPECT_EQ(reason("depth-of-field:sensor=2,aperture=64", 720),
              "its largest circle is under half a pixel");
    EXPECT_EQ(reason("depth-of-field:sensor=2,aperture=64,focus=3", 720),
              "its largest circle is under half a pixel");
    EXPECT_EQ(reason("depth-of-field:largest=1", 400), "its largest circle is under half a pixel");
    EXPECT_EQ(reason("depth-of-field:largest=2", 400), "");
}

} // namespace
} // namespace preview
