#include "lutlib/paint/denoise.h"

#include "lutlib/paint/whole.h"
#include "tests/lutlib/paint/shots.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

Lut3D lattice_of(const Transform& look, int size) {
    Lut3D cube = identity_cube(size);
    for (Rgb& node : cube.nodes) {
        node = to_float(saturate(look(to_double(node))));
    }
    return cube;
}

Lut3D with_noise(Lut3D cube, double codes) {
    const Picture noised = noisy({static_cast<int>(cube.nodes.size()), 1, cube.nodes}, codes);
    cube.nodes = noised.pixels;
    return cube;
}

double rms(const Lut3D& a, const Lut3D& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.nodes.size(); ++i) {
        const RgbD d = to_double(a.nodes[i] - b.nodes[i]);
        sum += d.r * d.r + d.g * d.g + d.b * d.b;
    }
    return 255 * std::sqrt(sum / (3.0 * static_cast<double>(a.nodes.size())));
}

TEST(Noise, of_a_lattice_is_what_was_added_to_it) {
    for (const int size : {16, 32}) {
        const Lut3D right = lattice_of(warm_look(), size);
        EXPECT_LT(noise_of(right), 0.1) << size;
        EXPECT_NEAR(noise_of(with_noise(right, 0)), 0.29, 0.1) << size;
        EXPECT_NEAR(noise_of(with_noise(right, 2)), 2, 0.3) << size;
    }
}

// Smoothing along three axes leaves a few of the degrees of freedom of the noise.
TEST(Denoise, comes_nearer_to_the_grade_by_half_and_moves_nothing_further_than_it_says) {
    for (const double codes : {1.0, 2.0, 4.0}) {
        const Lut3D right = lattice_of(warm_look(), 16), noised = with_noise(right, codes);
        const Denoised clean = denoised(noised, noise_of(noised));
        EXPECT_LT(rms(clean.cube, right), 0.5 * rms(noised, right)) << codes;
        double most = 0;
        for (std::size_t i = 0; i < noised.nodes.size(); ++i) {
            const double change =
                255 * largest_magnitude(to_double(clean.cube.nodes[i] - noised.nodes[i]));
            most = std::max(most, change);
        }
        EXPECT_NEAR(most, clean.largest, 1e-3);
        EXPECT_LE(clean.largest, clean.limit + 1e-3);
        EXPECT_GT(clean.moved, noised.nodes.size() / 2);
    }
}

TEST(Denoise, takes_off_the_rounding_to_8_bits) {
    const Lut3D right = lattice_of(warm_look(), 16), rounded = with_noise(right, 0);
    const Denoised clean = denoised(rounded, noise_of(rounded));
    EXPECT_LT(rms(clean.cube, right), 0.7 * rms(rounded, right));
    EXPECT_LE(clean.largest, 3 * noise_of(rounded) + 0.01);
}

TEST(Denoise, leaves_what_is_clipped_and_what_has_no_noise) {
    const Transform clipping = Transform::each([](RgbD c) { return c * 1.5 - RgbD{.2, .2, .2}; });
    const Lut3D noised = with_noise(lattice_of(clipping, 16), 1);
    const Denoised clean = denoised(noised, noise_of(noised));
    std::size_t clipped = 0;
    for (std::size_t i = 0; i < noised.nodes.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (noised.nodes[i][c] <= 0 || noised.nodes[i][c] >= 1) {
                EXPECT_EQ(clean.cube.nodes[i][c], noised.nodes[i][c]);
                ++clipped;
            }
        }
    }
    EXPECT_GT(clipped, 100U);
    const Denoised same = denoised(identity_cube(16), 0);
    EXPECT_EQ(same.moved, 0U);
}

TEST(Denoise, makes_rows_rise_that_fall_by_noise_alone) {
    const Lut3D noised = with_noise(lattice_of({}, 33), 4);
    const auto falls = [](const Lut3D& cube) {
        std::size_t out = 0;
        for (int i = 0; i + 1 < cube.size; ++i) {
            for (int k = 0; k < cube.size; ++k) {
                out += cube.at(i + 1, k, 0).r < cube.at(i, k, 0).r - 1e-6F;
            }
        }
        return out;
    };
    EXPECT_GT(falls(noised), 5U);
    EXPECT_LE(falls(denoised(noised, noise_of(noised)).cube), falls(noised) / 20);
}

} // namespace
} // namespace lutlib
