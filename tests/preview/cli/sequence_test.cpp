// What --frames says, and the names of a sequence's files.
#include "lutlib/error.h"
#include "preview/cli/sequence.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace preview
