// Where a window goes on the monitors, and what it remembers of that.
#include "preview/window/window_memory.h"
#include "preview/window/window_place.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace preview {
namespace {

bool is_within(const DesktopArea& inner, const FrameWidths& frame, const DesktopArea& outer) {
    return inner.x - frame.left >= outer.x && inner.y - frame.top >= outer.y &&
           inner.x + inner.width + frame.right <= outer.x + outer.width &&
           inner.y + inner.height + frame.bottom <= outer.y + outer.height;
}

constexpr FrameWidths titled{2, 30, 2, 2};

TEST(WindowPlace, is_as_usual_in_the_middle_of_a_large_monitor) {
    EXPECT_EQ(first_area({1600, 900}, {}, {100, 40, 2400, 1300}),
              (DesktopArea{500, 240, 1600, 900}));
}

TEST(WindowPlace, fits_a_small_monitor_with_its_frame) {
    const DesktopArea work{0, 24, 1280, 776};
    const DesktopArea area = first_area({1600, 900}, titled, work);
    EXPECT_TRUE(is_within(area, titled, work));
    EXPECT_EQ(area, (DesktopArea{2, 54, 1276, 744}));
}

TEST(WindowPlace, stays_where_it_was) {
    const DesktopArea works[] = {{0, 0, 1920, 1080}, {1920, 0, 2560, 1440}};
    const DesktopArea last{2000, 200, 1700, 1000};
    EXPECT_EQ(area_again(last, titled, works), last);
}

TEST(WindowPlace, comes_back_from_a_monitor_that_is_gone_and_is_never_outside) {
    const DesktopArea works[] = {{0, 0, 1280, 800}, {-1024, 100, 1024, 768}};
    for (const DesktopArea& last :
         {DesktopArea{3000, 2000, 1700, 1000}, DesktopArea{-5000, -5000, 10, 10},
          DesktopArea{-700, 300, 900, 500}, DesktopArea{1200, 700, 400, 300},
          DesktopArea{1 << 20, -(1 << 20), 1 << 20, 1 << 20}, DesktopArea{0, 0, 0, 0}}) {
        const DesktopArea area = area_again(last, titled, works);
        EXPECT_TRUE(is_within(area, titled, works[0]) || is_within(area, titled, works[1]))
            << last.x << ' ' << last.y;
    }
    // Most of it is on the second.
    EXPECT_TRUE(is_within(area_again({-700, 300, 900, 500}, titled, works), titled, works[1]));
    EXPECT_TRUE(is_within(area_again({3000, 2000, 170, 100}, titled, works), titled, works[0]));
}

TEST(WindowPlace, has_a_size_on_a_monitor_that_its_frame_fills) {
    const DesktopArea tiny{0, 0, 3, 20};
    EXPECT_GT(first_area({1600, 900}, titled, tiny).width, 0);
    EXPECT_GT(area_again({0, 0, 1600, 900}, titled, {&tiny, 1}).height, 0);
}

TEST(WindowMemory, is_read_as_it_was_written) {
    const WindowMemory all{DesktopArea{-12, 34, 1500, 820},
                           true,
                           1.1F,
                           28.5F,
                           {"/a.cube", "/b \"c\".exr"},
                           true,
                           "/looks of mine"};
    EXPECT_EQ(memory_from(text_of(all)), all);
    EXPECT_FALSE(memory_from(R"({"strip of looks": {"folder": "/a"}})").has_strip);
    EXPECT_EQ(memory_from(text_of({})), WindowMemory{});
    WindowMemory bytes;
    bytes.recent = {"/not \xff UTF-8"};
    EXPECT_EQ(memory_from(text_of(bytes)).recent.size(), 1U);
}

TEST(WindowMemory, brings_numbers_into_their_range) {
    const WindowMemory out =
        memory_from(R"({"area": {"x": -1e300, "y": 1e300, "width": -5, "height": 0},
                        "text scale": 1e9, "panels' width": -3})");
    ASSERT_TRUE(out.area);
    EXPECT_GE(out.area->width, 1);
    EXPECT_GE(out.area->height, 1);
    EXPECT_EQ(out.text_scale, most_text_scale);
    EXPECT_EQ(out.panels_width, 0);
    // Sums that are needed to place it do not overflow.
    const DesktopArea work{0, 0, 1280, 800};
    EXPECT_TRUE(is_within(area_again(*out.area, {}, {&work, 1}), {}, work));
}

TEST(WindowMemory, refuses_what_is_none_and_names_the_remedy) {
    for (const char* const text :
         {"", "[", "[]", "3", "{\"area\": 3}", "{\"area\": {\"x\": 1}}",
          "{\"text scale\": \"large\"}", "{\"maximised\": 1}", "{\"strip of looks\": 1}",
          "{\"strip of looks\": {\"open\": \"yes\"}}"}) {
        try {
            memory_from(text);
            ADD_FAILURE() << text;
        } catch (const lutlib::Error& error) {
            EXPECT_NE(std::string(error.what()).find("for the first time"), std::string::npos)
                << text;
        }
    }
}

class MemoryFileTest : public testing::Test {
  protected:
    lutlib::ScratchFolder scratch_;
    std::string path_ = scratch_.file("window.json");
};

TEST_F(MemoryFileTest, keeps_what_changes_and_writes_nothing_else) {
    MemoryFile file(path_);
    EXPECT_EQ(file.notice(), "");
    file.keep({});
    EXPECT_FALSE(std::filesystem::exists(path_));
    WindowMemory changed;
    changed.text_scale = 2;
    file.keep(changed);
    EXPECT_EQ(MemoryFile(path_).memory(), changed);
}

TEST_F(MemoryFileTest, says_of_a_broken_file_which_it_is_and_is_as_usual) {
    lutlib::io::write_file(path_, "not what it was");
    const MemoryFile file(path_);
    EXPECT_EQ(file.memory(), WindowMemory{});
    EXPECT_NE(file.notice().find(path_), std::string::npos) << file.notice();
    EXPECT_NE(file.notice().find("for the first time"), std::string::npos) << file.notice();
}

TEST_F(MemoryFileTest, says_once_that_it_cannot_be_written) {
    MemoryFile file(scratch_.file("absent/window.json"));
    WindowMemory changed;
    changed.panels_width = 40;
    EXPECT_THROW(file.keep(changed), lutlib::Error);
    changed.panels_width = 50;
    EXPECT_NO_THROW(file.keep(changed));
}

TEST_F(MemoryFileTest, does_nothing_without_a_path) {
    MemoryFile file("");
    WindowMemory changed;
    changed.is_maximised = true;
    EXPECT_NO_THROW(file.keep(changed));
    EXPECT_EQ(file.notice(), "");
}

} // namespace
} // namespace preview
