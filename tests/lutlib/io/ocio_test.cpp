#include "lutlib/io/ocio.h"

#include "lutlib/error.h"
#include "lutlib/formats/cube.h"
#include "lutlib/io/file.h"
#include "tests/lutlib/io/looks.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib::io {
namespace {

// Colours outside the domain too, of its width.
constexpr float margin = 0.1F;

double largest_difference(const Lut& lut, const Transform& oracle, Interpolation how) {
    const std::vector<Rgb> in = colors_in(lut.domain(), 100000, margin);
    const std::vector<RgbD> expected = images_of(oracle, in);
    double worst = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const RgbD difference = to_double(evaluate(lut, in[i], how)) - expected[i];
        worst = std::max(worst, largest_magnitude(difference));
    }
    return worst;
}

class Oracle : public testing::TestWithParam<std::tuple<Interpolation, Optimization>> {};
INSTANTIATE_TEST_SUITE_P(
    Ocio, Oracle,
    testing::Combine(testing::Values(Interpolation::trilinear, Interpolation::tetrahedral),
                     testing::Values(Optimization::none, Optimization::lossless)),
    [](const auto& row) {
        return std::string(name_of(std::get<0>(row.param))) +
               (std::get<1>(row.param) == Optimization::none ? "_as_is" : "_lossless");
    });

// The two compute a cell's fraction from products that differ by a rounding of the coordinate,
// 33 * 2^-25, times a cell's steepest step, about 0.1.
constexpr double agreement = 5e-7;

TEST_P(Oracle, agrees_with_our_evaluation_of_a_look_in_memory) {
    const auto& [how, optimization] = GetParam();
    for (const auto& [name, lut] : looks_of_every_shape(33)) {
        const auto oracle = ocio().from_lut(lut, {how, optimization});
        EXPECT_LT(largest_difference(lut, oracle, how), agreement) << name;
    }
}

TEST_P(Oracle, agrees_with_our_evaluation_of_a_file_that_it_parses_itself) {
    const auto& [how, optimization] = GetParam();
    for (const auto& [name, lut] : looks_of_every_shape(33)) {
        const std::string bytes = write_cube(lut, best_dialect(lut));
        const auto oracle = ocio().parse(bytes, "cube", "x.cube", {how, optimization});
        EXPECT_LT(largest_difference(lut, oracle, how), agreement) << name;
    }
}

TEST(Ocio, answers_one_color_as_it_answers_many_and_says_that_it_computes_in_float) {
    for (const auto& [name, lut] : looks_of_every_shape(33)) {
        const Transform oracle = ocio().from_lut(lut, {});
        EXPECT_EQ(oracle.precision(), Precision::float32);
        const std::vector<Rgb> in = colors_in(lut.domain(), 2500, margin);
        const std::vector<RgbD> many = images_of(oracle, in);
        for (std::size_t i = 0; i < in.size(); ++i) {
            ASSERT_EQ(oracle(to_double(in[i])), many[i]) << name << ' ' << i;
        }
    }
}

TEST(Ocio, opens_files_with_upper_case_suffixes_blanks_and_variables_in_their_names) {
    const ScratchFolder folder;
    const Lut lut = looks_of_every_shape()[0].lut;
    const std::string path = folder.file("My $HOME %d Look 100.CUBE");
    write_file(path, write_cube(lut, CubeDialect::adobe));
    EXPECT_LT(largest_difference(lut, open_in_ocio(path), Interpolation::tetrahedral), agreement);
}

TEST(Ocio, opens_a_file_at_its_own_path_except_where_it_would_not_find_it_there) {
    const ScratchFolder folder;
    const std::string text = "LUT_1D_SIZE 2\n0 0 0\n3 3 3\n";
    write_file(folder.file("My Look.cube"), text);
    write_file(folder.file("$HOME.cube"), text);
    const auto own = ocio().open(folder.file("My Look.cube"), {});
    ASSERT_TRUE(own);
    EXPECT_FLOAT_EQ(static_cast<float>((*own)({0.5, 0.5, 0.5}).r), 1.5F);
    EXPECT_FALSE(ocio().open(folder.file("$HOME.cube"), {}));
    EXPECT_FALSE(ocio().open("-", {}));
}

TEST(Ocio, reads_a_changed_file_anew) {
    const ScratchFolder folder;
    const std::string path = folder.file("x.cube");
    const RgbD grey{0.5, 0.5, 0.5};
    write_file(path, "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    EXPECT_FLOAT_EQ(static_cast<float>(open_in_ocio(path)(grey).r), 0.5F);
    write_file(path, "LUT_1D_SIZE 2\n0 0 0\n3 3 3\n");
    EXPECT_FLOAT_EQ(static_cast<float>(open_in_ocio(path)(grey).r), 1.5F);
}

TEST(Ocio, says_which_file_it_cannot_read_in_one_line) {
    try {
        ocio().parse("nonsense", "spi3d", "my look.spi3d", {});
        FAIL();
    } catch (const Error& e) {
        const std::string text = e.what();
        EXPECT_EQ(text.rfind("my look.spi3d: OpenColorIO cannot read it", 0), 0U) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
        EXPECT_EQ(text.find("lutlib-"), std::string::npos) << text;
    }
}

TEST(Ocio, refuses_nearest_which_it_would_silently_replace_by_linear) {
    EXPECT_THROW(ocio().from_lut(looks_of_every_shape()[0].lut,
                                 {Interpolation::nearest, Optimization::none}),
                 UsageError);
}

} // namespace
} // namespace lutlib::io
