#include "lutlib/io/samples.h"

#include "lutlib/codes.h"
#include "lutlib/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace lutlib::io {
namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

// One row with what is hard to round, to hold or to keep.
FloatImage row(bool alpha) {
    FloatImage out;
    out.rgba = {0, 0.5F, 1, 0.25F, -1, 2, 0.3F / 255, 1, 0.5F / 255, 1e5F, -endless, endless};
    out.rgba.insert(out.rgba.end(), {std::nanf(""), 6.1e-8F, 1e-5F, 0.75F});
    out.width = static_cast<int>(out.rgba.size() / 4);
    out.height = 1;
    out.alpha = alpha;
    return out;
}

TEST(Samples, of_floats_are_the_nearest_that_each_depth_holds) {
    for (const bool alpha : {false, true}) {
        const FloatImage image = row(alpha);
        const std::size_t channels = alpha ? 4 : 3;
        const SampleImage bytes = samples_of(image, Depth::uint8, alpha),
                          codes = samples_of(image, Depth::uint16, alpha),
                          halves = samples_of(image, Depth::half, alpha),
                          floats = samples_of(image, Depth::float32, alpha);
        for (std::size_t i = 0; i < image.pixels() * channels; ++i) {
            const float value = image.rgba[i / channels * 4 + i % channels];
            const auto exact = static_cast<double>(value);
            EXPECT_EQ(bytes.samples.as<std::uint8_t>()[i], CodeDepth{8}.code(exact)) << value;
            EXPECT_EQ(codes.samples.as<std::uint16_t>()[i], CodeDepth{16}.code(exact)) << value;
            if (std::isfinite(value)) {
                EXPECT_EQ(halves.samples.as<std::uint16_t>()[i], half_from(exact)) << value;
            }
            EXPECT_EQ(std::memcmp(&floats.samples.as<float>()[i], &value, sizeof value), 0);
        }
    }
}

TEST(Samples, become_floats_and_the_same_samples_again) {
    for (const DepthInfo& info : depths()) {
        for (const bool alpha : {false, true}) {
            const SampleImage first = samples_of(row(alpha), info.depth, alpha);
            const FloatImage floats = floats_of(samples_of(row(alpha), info.depth, alpha));
            const SampleImage again = samples_of(floats, info.depth, alpha);
            ASSERT_EQ(again.samples.size(), first.bytes());
            EXPECT_EQ(std::memcmp(again.samples.data(), first.samples.data(), first.bytes()), 0)
                << info.name;
            EXPECT_EQ(floats.rgba[3], alpha ? floats.rgba[3] : 1.0F);
        }
    }
}

TEST(Samples, are_opaque_where_no_alpha_is_below_1) {
    for (const DepthInfo& info : depths()) {
        FloatImage image = row(true);
        EXPECT_TRUE(is_opaque(samples_of(image, info.depth, false)));
        EXPECT_FALSE(is_opaque(samples_of(image, info.depth, true))) << info.name;
        for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
            image.rgba[i] = 1;
        }
        EXPECT_TRUE(is_opaque(samples_of(image, info.depth, true))) << info.name;
    }
}

} // namespace
} // namespace lutlib::io
