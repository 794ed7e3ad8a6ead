// PNG files one behind the other through apply.
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace converter_test {
namespace {

class PicturePipe : public testing::Test {
  protected:
    PicturePipe() {
        for (int i = 0; i < 9; ++i) {
            const std::string shift = folder_.path("shift.cube"), in = picture(i);
            lutconv_in_process({"edit", "identity", "-o", shift, "--size", "5", "--exposure",
                                "0." + std::to_string(i)});
            lutconv_in_process({"bake", shift, "-o", in});
            pictures_.push_back(contents(in));
        }
    }
    std::string picture(int i) const { return folder_.path(std::to_string(i) + ".png"); }
    static std::string joined(const std::vector<std::string>& files) {
        std::string out;
        for (const std::string& file : files) {
            out += file;
        }
        return out;
    }
    Folder folder_;
    std::string look_ = folder_.write("look.cube", saturated_cube(9));
    std::vector<std::string> pictures_;
};

TEST_F(PicturePipe, comes_out_in_order_whatever_is_worked_on_at_once) {
    const Result one =
        lutconv_process({"apply", look_, "-", "-o", "-", "--jobs", "1"}, joined(pictures_));
    ASSERT_EQ(one.exit_code, 0) << one.err;
    EXPECT_NE(one.err.find("9 pictures -> standard output"), std::string::npos) << one.err;
    const Result many =
        lutconv_process({"apply", look_, "-", "-o", "-", "--jobs", "5"}, joined(pictures_));
    EXPECT_EQ(many.out, one.out);
    // Each is what it is by itself.
    const Result files = lutconv_process({"apply", look_, "-", "-o", folder_.path("out/f.##.png")},
                                         joined(pictures_));
    ASSERT_EQ(files.exit_code, 0) << files.err;
    std::string all;
    for (int i = 1; i <= 9; ++i) {
        const std::string bytes = contents(folder_.path("out/f.0" + std::to_string(i) + ".png"));
        const Result alone = lutconv_process({"apply", look_, "-", "-o", "-"},
                                             pictures_[static_cast<std::size_t>(i) - 1]);
        EXPECT_EQ(bytes, alone.out) << i;
        all += bytes;
    }
    EXPECT_EQ(one.out, all);
}

TEST_F(PicturePipe, leaves_out_a_bad_picture_and_says_so) {
    std::vector<std::string> with_bad = pictures_, rest = pictures_;
    with_bad[3][with_bad[3].find("IDAT") + 20] ^= 1;
    rest.erase(rest.begin() + 3);
    const Result result = lutconv_process({"apply", look_, "-", "-o", "-"}, joined(with_bad));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("picture 4 of standard input: "), std::string::npos) << result.err;
    EXPECT_EQ(result.out, lutconv_process({"apply", look_, "-", "-o", "-"}, joined(rest)).out);
}

TEST_F(PicturePipe, that_breaks_off_is_written_as_far_as_it_was_whole) {
    const std::string whole = joined(pictures_);
    const Result result =
        lutconv_process({"apply", look_, "-", "-o", "-"}, whole.substr(0, whole.size() - 20));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("picture 9 is cut short"), std::string::npos) << result.err;
    const std::vector<std::string> first(pictures_.begin(), pictures_.end() - 1);
    EXPECT_EQ(result.out, lutconv_process({"apply", look_, "-", "-o", "-"}, joined(first)).out);
}

TEST_F(PicturePipe, whose_second_picture_is_cut_short_loses_not_the_first) {
    const std::string two = pictures_[0] + pictures_[1];
    const Result result =
        lutconv_process({"apply", look_, "-", "-o", "-"}, two.substr(0, two.size() - 20));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("picture 2 is cut short"), std::string::npos) << result.err;
    EXPECT_EQ(result.out, lutconv_process({"apply", look_, "-", "-o", "-"}, pictures_[0]).out);
}

TEST_F(PicturePipe, of_several_pictures_wants_a_place_for_each) {
    const Result result =
        lutconv_process({"apply", look_, "-", "-o", folder_.path("x.png")}, joined(pictures_));
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_FALSE(std::filesystem::exists(folder_.path("x.png")));
}

} // namespace
} // namespace converter_test
