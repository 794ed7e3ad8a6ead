// Files of every format that is only read, against OpenColorIO's own evaluation of the same file.
#include "lutlib/io/formats.h"
#include "lutlib/io/ocio.h"

#include "lutlib/io/file.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <set>

namespace lutlib::io {
namespace {

struct Expectation {
    std::string file;
    std::string_view loss; ///< how the loss is told that the reading has; empty: it has none
    double max_loss;       ///< largest error that this file should have
};

void PrintTo(const Expectation& e, std::ostream* out) {
    *out << e.file;
}

constexpr std::string_view sampled = "sampled onto";

const std::vector<Expectation>& expectations() {
    static const std::vector<Expectation> table{
        {"clamped.clf", "", 0},
        {"cube.look", "", 0},
        {"cube.m3d", "", 0},
        {"cube.mga", "", 0},
        {"cube.vf", "", 0},
        {"curve.lut", "", 0},
        {"display.icc", sampled, 0.1},
        {"grade.ccc", sampled, 0.002},
        {"grade.cdl", sampled, 0.002},
        {"inverse.ctf", sampled, 1e-4},
        {"matrix.spimtx", "", 0},
        {"plain.cc", sampled, 1e-4},
        {"post_curve.clf", sampled, 0.01},
        {"post_matrix.clf", "", 0},
        {"saturated.cc", sampled, 0.002},
        {"scaled.vf", "", 0},
        {"trilinear.clf", "", 0},
    };
    return table;
}

std::string path_of(const std::string& file) {
    return LUT_TEST_FILES "/" + file;
}

class EveryFile : public testing::TestWithParam<Expectation> {};
INSTANTIATE_TEST_SUITE_P(ReadFiles, EveryFile, testing::ValuesIn(expectations()),
                         [](const auto& row) { return support::test_name(row.param.file); });

TEST_P(EveryFile, differs_from_opencolorio_by_no_more_than_the_loss_it_reports) {
    const Reading reading = read_lut(path_of(GetParam().file));
    double loss = 0;
    for (const Loss& told : reading.table_losses) {
        const bool of_values = told.unit.empty() && told.what.rfind("inputs outside", 0) != 0;
        if (!of_values) {
            continue;
        }
        EXPECT_EQ(told.what.rfind(GetParam().loss, 0), 0U) << told.what;
        loss = told.figure;
    }
    EXPECT_EQ(loss > 0, !GetParam().loss.empty());
    EXPECT_LE(loss, GetParam().max_loss);

    const Domain domain = reading.lut.domain();
    std::mt19937 random(5);
    std::uniform_real_distribution<float> position(0, 1);
    std::vector<Rgb> in;
    for (int i = 0; i < 100000; ++i) {
        Rgb c;
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] = domain.min[k] + position(random) * (domain.max[k] - domain.min[k]);
        }
        in.push_back(c);
    }
    const std::vector<RgbD> expected = images_of(open_in_ocio(path_of(GetParam().file)), in);
    double worst = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const RgbD difference = to_double(evaluate(reading.lut, in[i])) - expected[i];
        worst = std::max(worst, largest_magnitude(difference));
    }
    // The loss was measured on other colours.
    EXPECT_LE(worst, 1.3 * loss + 5e-7);
}

TEST(ReadFiles, leave_no_file_of_the_folder_untested) {
    std::set<std::string> expected, found;
    for (const Expectation& e : expectations()) {
        expected.insert(e.file);
    }
    for (const auto& entry : std::filesystem::directory_iterator(LUT_TEST_FILES)) {
        if (entry.path().extension() != ".md") {
            found.insert(entry.path().filename());
        }
    }
    EXPECT_EQ(found, expected);
}

TEST(ReadFiles, cover_every_format_that_is_only_read) {
    for (const FileFormat* const row : file_formats()) {
        if (row->read && !row->write && !row->picture) {
            EXPECT_TRUE(std::any_of(expectations().begin(), expectations().end(),
                                    [&](const Expectation& e) {
                                        return extension_of(e.file) == row->extensions.first();
                                    }))
                << row->name;
        }
    }
}

TEST(ReadFiles, say_that_operators_go_on_outside_the_sampled_domain) {
    const Reading reading = read_lut(path_of("plain.cc"));
    EXPECT_TRUE(
        std::any_of(reading.table_losses.begin(), reading.table_losses.end(), [](const Loss& loss) {
            return loss.what.find("inputs outside 0..1 are clamped") == 0 && loss.figure > 0.1;
        }));
}

TEST(ReadFiles, know_which_interpolation_a_file_names) {
    EXPECT_EQ(read_lut(path_of("trilinear.clf")).lut.interpolation, Interpolation::trilinear);
    for (const char* unnamed : {"clamped.clf", "cube.look", "cube.vf"}) {
        EXPECT_FALSE(read_lut(path_of(unnamed)).lut.interpolation) << unnamed;
    }
}

TEST(ReadFiles, say_that_a_collection_holds_more_corrections) {
    const Reading reading = read_lut(path_of("grade.ccc"));
    EXPECT_TRUE(std::any_of(reading.losses.begin(), reading.losses.end(), [](const Loss& loss) {
        return loss.what.find("only the first colour correction") == 0 && loss.figure == 2;
    }));
}

TEST(ReadFiles, sample_onto_the_size_asked_for_with_an_error_that_falls_with_it) {
    const auto loss_at = [](int size) {
        const Reading reading = read_lut(path_of("saturated.cc"), {size});
        EXPECT_EQ(reading.lut.cube->size, size);
        return reading.table_losses.front().figure;
    };
    EXPECT_LT(loss_at(65), loss_at(17));
}

TEST(ReadFiles, takes_of_an_inverse_table_every_input_that_the_table_has) {
    const std::string ctf = R"(<ProcessList version="1.3" id="i">
<InverseLUT1D inBitDepth="32f" outBitDepth="32f"><Array dim="4 1">
-0.2
0.3
0.5
1.4
</Array></InverseLUT1D>)";
    const Lut curve = decode_lut(ctf + "</ProcessList>", "i.ctf").lut;
    EXPECT_FALSE(curve.cube);
    EXPECT_EQ(curve.domain(), (Domain{{-.2F, -.2F, -.2F}, {1.4F, 1.4F, 1.4F}}));
    for (const auto& [in, out] : {std::pair(-.2, 0.), {.05, 1 / 6.}, {.5, 2 / 3.}, {1.4, 1.}}) {
        EXPECT_NEAR(evaluate_exact(curve, {in, in, in}).g, out, 1e-5) << in;
    }
    // Before a matrix that mixes, it is the table before a cube.
    const Lut mixed = decode_lut(ctf + R"(<Matrix inBitDepth="32f" outBitDepth="32f">
<Array dim="3 3">0.5 0.5 0  0 1 0  0 0 1</Array></Matrix></ProcessList>)",
                                 "m.ctf")
                          .lut;
    ASSERT_TRUE(mixed.shaper && mixed.cube);
    EXPECT_EQ(mixed.domain(), curve.domain());
    const RgbD out = evaluate_exact(mixed, {1.4, .5, -.2});
    EXPECT_NEAR(out.r, (1 + 2 / 3.) / 2, 1e-5);
    EXPECT_NEAR(out.b, 0, 1e-5);
}

TEST(ReadFiles, tells_of_several_corrections_with_and_without_ids) {
    for (const bool has_ids : {false, true}) {
        std::string cdl = "<ColorDecisionList xmlns=\"urn:ASC:CDL:v1.01\">\n";
        for (int i = 0; i < 2; ++i) {
            const std::string id = has_ids ? " id=\"" + std::to_string(i) + "\"" : "";
            cdl += "<ColorDecision><ColorCorrection" + id +
                   "><SOPNode><Slope>1 1 1</Slope><Offset>0 0 0</Offset><Power>1 1 1</Power>"
                   "</SOPNode></ColorCorrection></ColorDecision>\n";
        }
        const Reading reading = decode_lut(cdl + "</ColorDecisionList>\n", "a.cdl");
        const bool told =
            std::any_of(reading.losses.begin(), reading.losses.end(), [](const Loss& loss) {
                return loss.unit == "corrections" && loss.figure == 2;
            });
        EXPECT_TRUE(told) << has_ids;
    }
}

} // namespace
} // namespace lutlib::io
