// The sky's numbers over the whole range of its settings and beyond it.
#include "preview/scene/sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace preview {
namespace {

/// Radiances in directions over the whole sphere, the zenith and the horizon among them.
std::vector<double> radiances(const Sky& sky) {
    const SkyBlock block = sky_block(sky);
    std::vector<double> out;
    for (const double y : {-1.0, -0.3, 0.0, 0.02, 0.3, 0.8, 1.0}) {
        const double across = std::sqrt(1 - y * y);
        for (int turn = 0; turn < 8; ++turn) {
            const glm::dvec3 color = sky_radiance(
                block, {across * std::sin(turn * 0.785398), y, across * std::cos(turn * 0.785398)});
            out.insert(out.end(), {color.x, color.y, color.z});
        }
    }
    const glm::dvec3 sun = sun_irradiance(sky);
    out.insert(out.end(), {sun.x, sun.y, sun.z});
    return out;
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

/// The largest change to the neighbouring setting, of the brighter one's largest value.
double change(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::abs(a[i] - b[i]));
    }
    return most / std::max(largest(a), largest(b));
}

void expect_sound(const Sky& sky, const std::vector<double>& values) {
    for (const double value : values) {
        ASSERT_TRUE(value >= 0 && std::isfinite(value))
            << sky.sun_height << ' ' << sky.turbidity << ' ' << value;
    }
}

TEST(SkyTest, has_no_negative_no_nan_and_no_jump_from_the_zenith_to_20_degrees_below) {
    for (const float turbidity : {1.0F, 2.0F, 3.0F, 10.0F, 30.0F}) {
        for (const float height : {90.0F, 60.0F, 30.0F, 10.0F, 3.0F, 1.0F, 0.5F, 0.25F, 0.05F, 0.0F,
                                   -0.05F, -0.3F, -1.0F, -6.0F, -12.0F, -19.95F}) {
            const Sky sky{height, 35, turbidity};
            const Sky below{height - 0.05F, 35, turbidity};
            const std::vector<double> values = radiances(sky);
            expect_sound(sky, values);
            // At sunset of the haziest sky, where it fades fastest, 7 % are a slope and no jump.
            EXPECT_LT(change(values, radiances(below)), 0.08) << height << ' ' << turbidity;
        }
    }
}

TEST(SkyTest, has_no_jump_over_turbidity) {
    for (const float height : {90.0F, 30.0F, 1.0F, -10.0F}) {
        for (const float turbidity :
             {1.0F, 1.6F, 1.95F, 2.0F, 2.05F, 3.0F, 6.0F, 9.95F, 10.0F, 12.0F, 29.95F}) {
            const Sky sky{height, 35, turbidity};
            const Sky hazier{height, 35, turbidity + 0.05F};
            const std::vector<double> values = radiances(sky);
            expect_sound(sky, values);
            EXPECT_LT(change(values, radiances(hazier)), 0.12) << height << ' ' << turbidity;
        }
    }
}

TEST(SkyTest, is_as_bright_and_as_blue_as_a_clear_day) {
    const Sky noon{60, 0, 2.5F};
    const glm::dvec3 zenith = sky_radiance(sky_block(noon), {0, 1, 0});
    EXPECT_GT(zenith.z, 1.5 * zenith.x);
    const double kilocandela =
        (0.2126 * zenith.x + 0.7152 * zenith.y + 0.0722 * zenith.z) / units_per_kilocandela;
    EXPECT_GT(kilocandela, 2); // clear zeniths have 2 to 10 kcd/m2
    EXPECT_LT(kilocandela, 10);
    const double sun = sun_irradiance(noon).y / units_per_kilocandela;
    EXPECT_GT(sun, 70); // klx
    EXPECT_LT(sun, 110);
    const glm::dvec3 low = sun_irradiance({5, 0, 2.5F});
    EXPECT_GT(low.x, 3 * low.z);
    EXPECT_EQ(sun_irradiance({-1, 0, 2.5F}).y, 0);
}

TEST(SkyTest, the_suns_disc_shines_as_its_irradiance_says_up_to_the_bound) {
    const Sky sky{40, 0, 3};
    const glm::dvec3 disc = sun_disc(sky, 1e9);
    const double solid_angle = 6.797e-5; // of 0.2665 degrees
    EXPECT_NEAR(disc.y * solid_angle, sun_irradiance(sky).y, 1e-3 * sun_irradiance(sky).y);
    const glm::dvec3 held = sun_disc(sky, 1000);
    EXPECT_NEAR(std::max({held.x, held.y, held.z}), 1000, 1e-6);
    EXPECT_NEAR(held.x / held.z, disc.x / disc.z, 1e-9) << "the bound keeps the colour";
}

} // namespace
} // namespace preview
