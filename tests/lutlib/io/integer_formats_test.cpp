// Formats of whole numbers, whose depth programs guess in different ways.
#include "lutlib/error.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/ocio.h"
#include "lutlib/metrics/scale.h"
#include "tests/lutlib/io/looks.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib::io {
namespace {

bool says(const std::vector<std::string>& sentences, const char* words) {
    return std::any_of(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
        return sentence.find(words) != std::string::npos;
    });
}

Transform by_opencolorio(const std::string& bytes) {
    return ocio().parse(bytes, "3dl", "x.3dl", {});
}

// The largest difference between OpenColorIO's evaluation of a file and a look, over random
// colours.
double difference_to_opencolorio(const std::string& bytes, const Lut& lut) {
    const std::vector<Rgb> in = colors_in({});
    const std::vector<RgbD> theirs = images_of(by_opencolorio(bytes), in);
    double worst = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
        worst =
            std::max(worst, largest_magnitude(theirs[i] - evaluate_exact(lut, to_double(in[i]))));
    }
    return worst;
}

TEST(Autodesk3dl, of_every_size_is_read_by_opencolorio_as_the_look_it_is) {
    for (const char* name : {"flame", "lustre"}) {
        for (const int size :
             support::all_or<int>({4, 5, 9, 16, 17, 25, 32, 33, 48, 65, 129}, {4, 17, 25, 32})) {
            Lut lut;
            lut.cube = graded_cube(size, {});
            const Encoded file = encode_lut(lut, require_file_format(name));
            const Lut back = decode_lut(file.bytes, "x.3dl").lut;
            EXPECT_FALSE(back.shaper) << size;
            EXPECT_LT(difference_to_opencolorio(file.bytes, back), 1e-6) << name << size;
        }
    }
}

TEST(Autodesk3dl, of_a_lattice_too_small_or_too_large_for_it_is_resampled_onto_one_it_has) {
    Lut lut;
    lut.cube = graded_cube(3, {});
    for (Rgb& node : lut.cube->nodes) {
        node = saturate(node); // as codes are
    }
    const Encoded small = encode_lut(lut, require_file_format("flame"));
    EXPECT_EQ(small.lut.cube->size, 5);
    EXPECT_LT(difference_to_opencolorio(small.bytes, lut), 0.6 / 4095);
    lut.cube = identity_cube(160);
    EXPECT_EQ(encode_lut(lut, require_file_format("flame")).lut.cube->size, 129);
    EXPECT_THROW(encode_lut(lut, require_file_format("flame"), {.title = {}, .size = 3}), Error);
}

TEST(Autodesk3dl, of_a_dark_look_is_read_back_right_and_says_who_takes_it_for_brighter) {
    Lut dark;
    dark.cube = identity_cube(17);
    for (Rgb& node : dark.cube->nodes) {
        node = node * 0.1F;
    }
    const Encoded file = encode_lut(dark, require_file_format("flame"));
    EXPECT_TRUE(says(file.readers, "OpenColorIO and three.js take its codes"));
    const Lut back = decode_lut(file.bytes, "x.3dl").lut;
    EXPECT_NEAR(back.cube->nodes.back().r, 0.1, 2e-4);
    const auto scale = scale_between(
        by_opencolorio(file.bytes), Transform::of(back, Interpolation::tetrahedral), colors_in({}));
    ASSERT_TRUE(scale);
    EXPECT_NEAR(*scale, 4095.0 / 255, 1e-3);
}

TEST(DiscreetLut, says_its_depth_in_its_name) {
    std::string table = "LUT: 1 1024\n";
    for (int i = 0; i < 1024; ++i) {
        table += std::to_string(i / 4) + '\n';
    }
    const auto white = [&](const char* name) {
        return evaluate_exact(decode_lut(table, name).lut, {1, 1, 1}).g;
    };
    EXPECT_NEAR(white("dir to12/log10to8.lut"), 1, 1e-6);
    EXPECT_NEAR(white("a$b 10to8.lut"), 1, 1e-6);
    EXPECT_NEAR(white("plain.lut"), 255.0 / 1023, 1e-6);
}

TEST(DiscreetLut, of_codes_beyond_its_input_depth_has_the_depth_that_they_need_and_says_so) {
    std::string table = "LUT: 1 1024\n";
    for (int i = 0; i < 1024; ++i) {
        table += std::to_string(i * i / 41) + '\n';
    }
    const Reading read = decode_lut(table, "plain.lut");
    const Lut& lut = read.lut;
    EXPECT_NEAR(evaluate_exact(lut, {1, 1, 1}).g, 25525.0 / 65535, 1e-6);
    EXPECT_TRUE(read.table_losses.empty());
    ASSERT_EQ(lut.notes.size(), 1U);
    EXPECT_NE(lut.notes[0].find("16 bits by the largest, 25525"), std::string::npos)
        << lut.notes[0];
}

} // namespace
} // namespace lutlib::io
