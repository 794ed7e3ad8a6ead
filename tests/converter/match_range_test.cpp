// Where AFTER's codes end, lutconv match does not know whether the look goes on.
#include "lutlib/io/formats.h"
#include "tests/converter/match_fixture.h"

#include <filesystem>

namespace converter_test {
namespace {

TEST_F(MatchVerb, ends_where_after_s_codes_end_unless_a_look_that_goes_on_is_nearer) {
    const auto learnt_of = [&](const std::string& cube) {
        folder_.write("grade.cube", cube);
        EXPECT_EQ(lutconv_in_process({"apply", in("grade.cube"), in("before.png"), "-o",
                                      in("after.png"), "--force"})
                      .exit_code,
                  0);
        const json said = matched();
        float least = 1, most = 0;
        const lutlib::Lut look = io::read_lut(in("look.cube")).lut;
        for (const lutlib::Rgb& node : look.cube->nodes) {
            least = std::min({least, node.r, node.g, node.b});
            most = std::max({most, node.r, node.g, node.b});
        }
        EXPECT_EQ(!said["remarks"].empty(), least < 0 || most > 1) << said["remarks"];
        return most;
    };
    const auto gain = [](int size, double slope, double end) {
        std::string out = "LUT_3D_SIZE " + std::to_string(size) + '\n';
        for (int i = 0; i < size * size * size; ++i) {
            for (const int at : {i % size, i / size % size, i / size / size}) {
                out += std::to_string(std::min(slope * at / (size - 1), end)) + ' ';
            }
            out += '\n';
        }
        return out;
    };
    EXPECT_EQ(learnt_of(gain(support::is_sanitized ? 9 : 17, 1.6, 1)), 1)
        << "a lattice that ends at its nodes";
    EXPECT_GT(learnt_of(gain(2, 1.5, 1.5)), 1.05F)
        << "one that a file of codes ended between its nodes";
}

TEST_F(MatchVerb, says_that_nothing_was_graded_and_that_it_has_few_pixels) {
    const std::string of_a_grade = matched()["remarks"].dump();
    EXPECT_EQ(of_a_grade.find("nothing was graded"), std::string::npos) << of_a_grade;
    EXPECT_EQ(of_a_grade.find("tell little"), std::string::npos) << of_a_grade;
    write("after.png", read("before.png"));
    json said = matched();
    ASSERT_EQ(said["remarks"].size(), 1U) << said["remarks"];
    EXPECT_NE(said["remarks"][0].get<std::string>().find("nothing was graded"), std::string::npos);
    write("before.png", shot(0, 24, 16));
    std::filesystem::remove(in("after.png"));
    grade("before.png", "after.png");
    said = matched();
    EXPECT_NE(said["remarks"].dump().find("384 pixels tell little"), std::string::npos)
        << said["remarks"];
}

} // namespace
} // namespace converter_test
