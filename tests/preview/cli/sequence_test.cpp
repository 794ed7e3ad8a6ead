// What --frames says, and the names of a sequence's files.
#include "lutlib/error.h"
#include "preview/cli/sequence.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace preview {
namespace {

TEST(Sequence, is_a_range_and_else_a_count) {
    EXPECT_EQ(parse_frames("7").count, 7);
    EXPECT_FALSE(parse_frames("7").range);
    EXPECT_EQ(parse_frames("3-119").range->first, 3);
    EXPECT_EQ(parse_frames("3-119").range->last, 119);
    EXPECT_EQ(parse_frames("0-0").range->last, 0);
    for (const char* wrong : {"", "0", "-3", "3-", "-", "9-3", "1-2-3", "1 - 2", "x", "5x", "1e3",
                              "0-100001", "99999999999"}) {
        EXPECT_THROW(parse_frames(wrong), lutlib::UsageError) << wrong;
    }
}

TEST(Sequence, numbers_its_files_where_the_last_run_of_hashes_stands) {
    EXPECT_EQ(frame_path("out.####.png", 7), "out.0007.png");
    EXPECT_EQ(frame_path("####", 12345), "12345");
    EXPECT_EQ(frame_path("#a/b##.exr", 3), "#a/b03.exr");
    EXPECT_THROW(frame_path("out.png", 7), lutlib::UsageError);
    EXPECT_THROW(frame_path("", 7), lutlib::UsageError);
}

TEST(Sequence, alone_has_hashes_in_its_files_names) {
    EXPECT_THROW(refuse_hashes("out.####.png"), lutlib::UsageError);
    EXPECT_THROW(refuse_hashes("##"), lutlib::UsageError);
    EXPECT_NO_THROW(refuse_hashes("look#1.png"));
    EXPECT_NO_THROW(refuse_hashes(""));
}

TEST(Sequence, has_a_frame_where_a_file_with_something_in_it_is) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "a_frame_is_there";
    std::filesystem::create_directories(folder);
    const std::string path = (folder / "0001.png").string();
    EXPECT_FALSE(is_frame_there(path));
    std::ofstream(path).close();
    EXPECT_FALSE(is_frame_there(path)) << "it is empty";
    std::ofstream(path) << "x";
    EXPECT_TRUE(is_frame_there(path));
    EXPECT_FALSE(is_frame_there(folder.string()));
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace preview
