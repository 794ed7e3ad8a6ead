// What the .cube reader keeps of a file beside its tables, and gives back.
#include "lutlib/formats/cube.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lutlib {
namespace {

TEST(Cube, keeps_comments_and_unknown_keywords_in_order_and_writes_both_back) {
    const Lut lut = read_cube("# one\nLUT_IN_VIDEO_RANGE\n; a note\nVENDOR 1 2\nLUT_1D_SIZE 2\n"
                              "0 0 0\n#two\n1 1 1\nEND\n",
                              "c");
    const std::vector<std::string> comments{"one", "; a note", "two"};
    const std::vector<std::string> keywords{"LUT_IN_VIDEO_RANGE", "VENDOR 1 2", "END"};
    EXPECT_EQ(lut.comments, comments);
    EXPECT_EQ(lut.keywords, keywords);
    for (const CubeDialect dialect : {CubeDialect::adobe, CubeDialect::resolve}) {
        const Lut again = read_cube(write_cube(lut, dialect), "again");
        EXPECT_EQ(again.comments, comments);
        EXPECT_EQ(again.keywords, keywords);
    }
}

TEST(Cube, keeps_a_line_of_binary_bytes_as_a_comment_so_that_what_it_writes_is_a_cube) {
    const Lut lut = read_cube("LUT_1D_SIZE 2\nPK\5\6ANGE 0 1 0\n0 0 0\n1 1 1\n", "x.cube");
    EXPECT_TRUE(lut.keywords.empty());
    EXPECT_EQ(lut.comments.size(), 1U);
    EXPECT_EQ(read_cube(write_cube(lut, CubeDialect::adobe), "y.cube").shaper, lut.shaper);
}

TEST(Cube,
     keeps_a_line_that_begins_another_things_file_as_a_comment_so_that_what_it_writes_is_a_cube) {
    for (const std::string line :
         {"version https://git-lfs.github.com/spec/v1", "BZh91AY 1 2", "VERSION-less"}) {
        const bool another = line.front() != 'V';
        const Lut lut = read_cube("LUT_1D_SIZE 2\n" + line + "\n0 0 0\n1 1 1\n", "x.cube");
        EXPECT_EQ(lut.keywords.size(), another ? 0U : 1U) << line;
        EXPECT_EQ(lut.comments.size(), another ? 1U : 0U) << line;
        for (const CubeDialect dialect : {CubeDialect::adobe, CubeDialect::resolve}) {
            const Lut again = read_cube(write_cube(lut, dialect), "y.cube");
            EXPECT_EQ(again.shaper, lut.shaper) << line;
            EXPECT_EQ(again.comments, lut.comments) << line;
        }
    }
}

TEST(CubeNotes, say_decimal_commas_once_and_a_file_cut_inside_its_last_number) {
    const Lut commas = read_cube("LUT_1D_SIZE 3\n0 0 0\n0,25 0,5 0,75\n0,5 1 1", "x.cube");
    ASSERT_EQ(commas.notes.size(), 1U);
    EXPECT_EQ(commas.notes[0].find("line 3: decimal commas, read as points"), 0U);
    const Lut remarked =
        read_cube("LUT_1D_SIZE 2\n0 0 0 # black, v. 1.0\n0,5 0,5 1 # white, v. 1.0\n", "x.cube");
    EXPECT_EQ(remarked.notes.size(), 1U) << "points of a comment are none of the row's";
    EXPECT_EQ(remarked.shaper->entries[1].r, 0.5F);
    const std::string whole = "LUT_1D_SIZE 2\n0 0 0\n0.98431 0.97213 0.95002";
    EXPECT_TRUE(read_cube(whole, "x.cube").notes.empty());
    EXPECT_TRUE(read_cube(whole.substr(0, whole.size() - 3) + "\n", "x.cube").notes.empty());
    const Lut cut = read_cube(whole.substr(0, whole.size() - 3), "x.cube");
    ASSERT_EQ(cut.notes.size(), 1U);
    EXPECT_EQ(cut.notes[0].find("line 3: the file ends without a line end"), 0U);
}

TEST(CubeEncodings, are_two_comments_that_reader_and_writer_share) {
    Lut lut = read_cube("# input ENCODING:  slog3/sgamut3.cine\n#Output encoding: gamma24/rec709\n"
                        "# by hand\n# Input encoding: logc3\nLUT_1D_SIZE 2\n0 0 0\n1 1 1\n",
                        "x.cube");
    EXPECT_EQ(lut.encodings, (EncodingNames{"slog3/sgamut3.cine", "gamma24/rec709"}));
    // A second one decides nothing and is kept as what it is, a comment.
    EXPECT_EQ(lut.comments, (std::vector<std::string>{"by hand", "Input encoding: logc3"}));
    ASSERT_EQ(lut.notes.size(), 1U);
    EXPECT_NE(lut.notes[0].find("'slog3/sgamut3.cine' and 'logc3'"), std::string::npos);
    EXPECT_NE(lut.notes[0].find("--look-input"), std::string::npos);
    lut.comments.pop_back();
    lut.comments.push_back("OUTPUT encoding : srgb");
    for (const CubeDialect dialect : {CubeDialect::adobe, CubeDialect::resolve}) {
        const std::string text = write_cube(lut, dialect);
        EXPECT_NE(text.find("# Input encoding: slog3/sgamut3.cine\n"), std::string::npos);
        const Lut again = read_cube(text, "y.cube");
        EXPECT_EQ(again.encodings, lut.encodings);
        EXPECT_EQ(again.comments, std::vector<std::string>{"by hand"});
        EXPECT_TRUE(again.notes.empty());
    }
}

TEST(CubeEncodings, have_blanks_on_either_side_of_the_colon) {
    const Lut lut = read_cube("# Input encoding : logc3\nLUT_1D_SIZE 2\n0 0 0\n1 1 1\n", "x.cube");
    EXPECT_EQ(lut.encodings.input, "logc3");
}

TEST(CubeEncodings, that_nobody_knows_are_kept_and_empty_ones_are_comments) {
    const Lut lut = read_cube("# Input encoding: some kind of log\n# Output encoding:\n"
                              "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n",
                              "x.cube");
    EXPECT_EQ(lut.encodings, (EncodingNames{"some kind of log", ""}));
    EXPECT_EQ(lut.comments.size(), 1U);
}

} // namespace
} // namespace lutlib
