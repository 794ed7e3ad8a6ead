#include "lutlib/number_text.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

namespace lutlib {
namespace {

TEST(NumberText, is_the_shortest_that_reads_back) {
    EXPECT_EQ(shortest(0.1F), "0.1");
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(1.0), "1");
    EXPECT_EQ(shortest(1e-7F), "1e-07");
    EXPECT_EQ(shortest(-0.0F), "-0");
}

TEST(NumberText, every_float_reads_back_bit_for_bit_with_and_without_exponents) {
    std::mt19937 random(5);
    for (int i = 0; i < 20000; ++i) {
        const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(value)) {
            continue;
        }
        for (const Exponents exponents : {Exponents::allowed, Exponents::rare}) {
            std::string text;
            append_number(text, value, exponents);
            EXPECT_EQ(std::strtof(text.c_str(), nullptr), value) << text;
        }
    }
}

TEST(NumberText, has_no_exponents_within_the_range_of_looks) {
    std::string rows;
    append_rows(rows, std::array<Rgb, 2>{Rgb{1e-7F, 1, -0.25F}, Rgb{1e8F, 0, 1e-10F}},
                Exponents::rare);
    EXPECT_EQ(rows, "0.0000001 1 -0.25\n100000000 0 1e-10\n");
}

} // namespace
} // namespace lutlib
