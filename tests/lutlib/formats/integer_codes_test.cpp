// Tables of whole numbers behind the keywords of a .cube: codes, or numbers as they stand.
#include "lutlib/formats/integer_codes.h"

#include "lutlib/formats/cube.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lutlib {
namespace {

/// A curve of `n` entries: x^0.7 of the largest code, rounded; `head` stands before it.
std::string curve_text(int n, double largest, const std::string& head = {}) {
    std::string out = head + "LUT_1D_SIZE " + std::to_string(n) + "\n";
    for (int i = 0; i < n; ++i) {
        const std::string v =
            std::to_string(std::lround(std::pow(i / (n - 1.0), 0.7) * largest)) + ' ';
        out += v + v + v + '\n';
    }
    return out;
}

TEST(IntegerCodes, of_every_usual_depth_become_0_to_1_with_a_note_of_the_guess) {
    for (const int bits : {8, 10, 12, 14, 16}) {
        const Lut lut = read_cube(curve_text(33, largest_code(bits)), "a.cube");
        EXPECT_EQ(lut.shaper->entries.back(), (Rgb{1, 1, 1})) << bits;
        EXPECT_NEAR(lut.shaper->entries[16].g, std::pow(0.5, 0.7), 0.51 / largest_code(bits));
        ASSERT_EQ(lut.notes.size(), 1U);
        EXPECT_NE(lut.notes[0].find("guessed to be " + std::to_string(bits) + "-bit"),
                  std::string::npos)
            << lut.notes[0];
    }
}

TEST(IntegerCodes, of_a_vlt_have_12_bits_however_dark_they_are) {
    const std::string head = "# panasonic vlt file version 1.0\n# source vlt file \"\"\n";
    const Lut dark = read_cube(curve_text(17, 900, head), "dark.txt");
    EXPECT_FLOAT_EQ(dark.shaper->entries.back().r, 900.0F / 4095);
    EXPECT_EQ(read_cube(curve_text(17, 900), "DARK.VLT").shaper->entries, dark.shaper->entries);
    ASSERT_EQ(dark.notes.size(), 1U);
    EXPECT_EQ(dark.notes[0].find("guess"), std::string::npos);
}

TEST(IntegerCodes, over_an_input_range_of_codes_lose_that_too) {
    const Lut lut = read_cube(curve_text(17, 1023, "LUT_1D_INPUT_RANGE 0 1023\n"), "a.cube");
    EXPECT_TRUE(lut.domain().is_unit());
    EXPECT_EQ(lut.shaper->entries.back(), (Rgb{1, 1, 1}));
}

TEST(IntegerCodes, are_not_seen_in_intensities) {
    // Whole numbers that stay inside their own input range, and a single fraction.
    for (const std::string& text :
         {curve_text(17, 200, "DOMAIN_MAX 200 200 200\n"),
          std::string("LUT_1D_SIZE 3\n0 0 0\n200.5 200 200\n400 400 400\n"),
          std::string("LUT_1D_SIZE 2\n-1 0 0\n400 400 400\n")}) {
        const Lut lut = read_cube(text, "a.cube");
        EXPECT_GE(lut.shaper->entries.back().r, 100) << text;
        EXPECT_TRUE(lut.notes.empty());
    }
}

TEST(IntegerCodes, over_an_input_range_of_codes_have_its_depth_however_dark_they_are) {
    for (const int bits : {10, 12}) {
        const std::string top = std::to_string(std::lround(largest_code(bits)));
        for (const double largest : {100.0, 500.0}) {
            const std::string range = "DOMAIN_MAX " + top + ' ' + top + ' ' + top + '\n';
            const Lut lut = read_cube(curve_text(17, largest, range), "a.cube");
            EXPECT_TRUE(lut.domain().is_unit());
            EXPECT_FLOAT_EQ(lut.shaper->entries.back().r,
                            static_cast<float>(largest / largest_code(bits)));
            EXPECT_EQ(lut.notes.size(), 1U);
        }
    }
}

TEST(IntegerCodes, too_small_for_any_depth_are_read_as_they_are_and_said) {
    const Lut lut = read_cube(curve_text(17, 100), "a.cube");
    EXPECT_EQ(lut.shaper->entries.back().r, 100);
    ASSERT_EQ(lut.notes.size(), 1U);
    EXPECT_NE(lut.notes[0].find("up to 100: read as they are"), std::string::npos) << lut.notes[0];
    EXPECT_TRUE(read_cube(curve_text(2, 1), "a.cube").notes.empty());
}

} // namespace
} // namespace lutlib
