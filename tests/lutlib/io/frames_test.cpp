#include "lutlib/io/frames.h"

#include "lutlib/error.h"

#include <gtest/gtest.h>

namespace lutlib::io {
namespace {

TEST(Frames, are_named_by_numbers_ranges_and_steps) {
    EXPECT_EQ(parse_frames("7"), (std::vector{7}));
    EXPECT_EQ(parse_frames("8-11"), (std::vector{8, 9, 10, 11}));
    EXPECT_EQ(parse_frames("1001-1007x3"), (std::vector{1001, 1004, 1007}));
    EXPECT_EQ(parse_frames("1001-1008x3"), (std::vector{1001, 1004, 1007}));
    EXPECT_EQ(parse_frames("9,1-3,2"), (std::vector{1, 2, 3, 9}));
    EXPECT_EQ(parse_frames("999999998-999999999"), (std::vector{999999998, last_frame}));
}

TEST(Frames, that_cannot_be_read_are_refused) {
    for (const char* const text :
         {"",      "-",     "x",       "1-",          "-3",         "3-1",
          "1x2",   "1-5x0", "1-5x",    "a",           "1,",         ",1",
          "1 - 3", "1-2-3", "1-3x2x2", "0-999999999", "1000000000", "99999999999999999999",
          "+1",    "1.5",   "5x-2"}) {
        EXPECT_THROW(parse_frames(text), UsageError) << text;
    }
}

struct Named {
    const char* pattern;
    int frame;
    const char* path;
};

TEST(FramePattern, fills_in_the_number_and_finds_it_again) {
    for (const auto& [pattern, frame, path] :
         {Named{"shot.####.exr", 7, "shot.0007.exr"},
          Named{"shot.####.exr", 12345, "shot.12345.exr"},
          Named{"shot.%04d.exr", 7, "shot.0007.exr"}, Named{"%d.png", 12, "12.png"},
          Named{"a##b.###", 5, "a##b.005"}, Named{"d##/s_##.exr", 3, "d##/s_03.exr"},
          Named{"%02d%%.png", 1, "01%%.png"}, Named{"##", 0, "00"}}) {
        const auto found = FramePattern::of(pattern);
        ASSERT_TRUE(found) << pattern;
        EXPECT_EQ(found->path_of(frame), path);
        const auto number = found->frame_in(path);
        ASSERT_TRUE(number) << path;
        EXPECT_EQ(std::stoi(*number), frame);
    }
}

TEST(FramePattern, is_no_single_hash_unless_that_is_asked_for_and_nothing_in_a_folder) {
    for (const char* const name :
         {"", "plain.png", "take #1.png", "d####/x.png", "%s.png", "%4d.png", "%00d.png",
          "100%.png", "%", "%0", "##########.png"}) {
        EXPECT_FALSE(FramePattern::of(name)) << name;
    }
    EXPECT_EQ(FramePattern::of("take #.png", 1)->path_of(12), "take 12.png");
}

TEST(FramePattern, takes_no_other_names_for_frames) {
    const auto pattern = FramePattern::of("shot.####.exr");
    for (const char* const path :
         {"shot.7.exr", "shot.00007.exr", "shot.007a.exr", "shot..exr", "shot.0007.ex", "", "x",
          "hot.0007.exr", "shot.-007.exr", "shot.0007.exr~", "shot.1234567890.exr"}) {
        EXPECT_FALSE(pattern->frame_in(path)) << path;
    }
}

} // namespace
} // namespace lutlib::io
