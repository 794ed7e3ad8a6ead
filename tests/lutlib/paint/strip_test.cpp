#include "lutlib/paint/find_bare.h"
#include "lutlib/paint/find_mark.h"
#include "tests/lutlib/paint/shots.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

// Rounding of what was placed is undone along straight lines, and that of what was graded is half a
// code; what bends in between adds a tenth.
constexpr double rounded_to_8_bits = 0.6;

TEST(Mark, says_what_it_was_made_of_in_every_layout_size_and_depth) {
    std::size_t read = 0;
    for (const Layout& layout : layouts()) {
        for (int size = 2; size <= 256; ++size) {
            for (const int bits : {8, 16}) {
                for (int row = 0; layout.picture(size) && row < 2; ++row) {
                    const Framed framed{&layout, size, bits};
                    const auto reading = read_mark(mark_row(framed, row));
                    ASSERT_TRUE(reading.has_value()) << layout.name << size;
                    EXPECT_EQ(reading->framed, framed);
                    EXPECT_EQ(reading->row, row);
                    ++read;
                }
            }
        }
    }
    EXPECT_GT(read, 3000U);
}

TEST(Mark, with_a_wrong_cell_is_none) {
    const MarkRow right = mark_row({layout_named("strip"), 16}, 0);
    for (std::size_t i = 0; i < right.size(); ++i) {
        MarkRow wrong = right;
        wrong[i] = !wrong[i];
        EXPECT_FALSE(read_mark(wrong).has_value()) << i;
    }
}

TEST(Turn, takes_every_pixel_where_it_goes_and_back) {
    const PictureSize size{5, 3};
    for (const Turn turn : all_turns()) {
        const PictureSize to = turned(size, turn);
        for (int y = 0; y < to.height; ++y) {
            for (int x = 0; x < to.width; ++x) {
                EXPECT_EQ(after_turn(before_turn({x, y}, size, turn), size, turn), (Pixel{x, y}));
            }
        }
    }
    // A quarter clockwise brings the lower left corner to the upper left.
    EXPECT_EQ(after_turn({0, 2}, size, {1, false}), (Pixel{0, 0}));
    EXPECT_EQ(after_turn({0, 0}, size, {0, true}), (Pixel{0, 2}));
}

struct Placed {
    const char* layout;
    int size;
};
class FramedStrip : public testing::TestWithParam<Placed> {};
INSTANTIATE_TEST_SUITE_P(Layouts, FramedStrip,
                         testing::Values(Placed{"strip", 16}, Placed{"strip-up", 32},
                                         Placed{"strip-vertical", 16}, Placed{"ocio", 17},
                                         Placed{"hald", 16}, Placed{"tiles", 16}),
                         [](const auto& row) {
                             std::string name = row.param.layout;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(FramedStrip, is_found_in_every_turn_and_holds_the_grade) {
    const Framed framed{layout_named(GetParam().layout), GetParam().size};
    const Picture frame = frame_picture(framed);
    Picture shot = screenshot(frame.width + 90, frame.height + 70);
    put(shot, frame, {37, 21});
    for (const Transform& look : {Transform{}, warm_look(), negative_look()}) {
        const Picture upright = graded(shot, look);
        for (const Turn turn : all_turns()) {
            const std::vector<FoundStrip> found = find_strips(turned(upright, turn));
            ASSERT_EQ(found.size(), 1U) << words_of(turn);
            const FoundStrip& strip = found.front();
            EXPECT_EQ(strip.framed, framed);
            EXPECT_EQ(frame_area(strip).left, 37);
            EXPECT_EQ(frame_area(strip).top, 21);
            const Picture again = turned(turned(upright, turn), strip.turn);
            EXPECT_TRUE(again.pixels == upright.pixels) << words_of(turn);
            EXPECT_LT(off_from(lattice_in(again, strip), look), rounded_to_8_bits);
        }
    }
}

TEST(FramedStrip, of_no_grade_gives_the_identity_to_the_last_bits_of_a_float) {
    for (const int size : {16, 32, 33}) {
        const Framed framed{layout_named("strip"), size};
        const std::vector<FoundStrip> found = find_strips(frame_picture(framed));
        ASSERT_EQ(found.size(), 1U);
        EXPECT_LT(off_from(lattice_in(frame_picture(framed), found[0]), {}), 1e-4) << size;
    }
}

TEST(FramedStrip, tells_its_scale) {
    Picture shot = screenshot(400, 200);
    put(shot, frame_picture({layout_named("strip"), 16}), {40, 60});
    for (const double by : {0.5, 0.75, 1.5, 2.0}) {
        const std::vector<FoundMark> marks = find_marks(scaled(graded(shot, warm_look()), by));
        ASSERT_EQ(marks.size(), 1U) << by;
        EXPECT_NEAR(marks[0].scale, by, 0.02 * by);
    }
    EXPECT_TRUE(find_marks(screenshot(400, 200)).empty());
}

TEST(Reduced, undoes_an_enlargement_by_whole_pixels_alone) {
    const Picture shot = screenshot(40, 30);
    Picture twice{80, 60, {}};
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 80; ++x) {
            twice.pixels.push_back(shot.at(x / 2, y / 2));
        }
    }
    const auto small = reduced(twice);
    ASSERT_TRUE(small.has_value());
    EXPECT_EQ(small->by, 2);
    EXPECT_TRUE(small->picture.pixels == shot.pixels);
    twice.at(3, 3).r += 0.1F;
    EXPECT_FALSE(reduced(twice).has_value());
}

class BareStripIn : public testing::TestWithParam<Placed> {};
const std::vector<Placed> bare{{"strip", 16}, {"strip-up", 16}, {"strip-vertical", 16},
                               {"ocio", 16},  {"hald", 16},     {"tiles", 16},
                               {"strip", 17}, {"tiles", 64}};
INSTANTIATE_TEST_SUITE_P(Layouts, BareStripIn, testing::ValuesIn(support::rows_to_try(bare)),
                         [](const auto& row) {
                             std::string name =
                                 std::string(row.param.layout) + std::to_string(row.param.size);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(BareStripIn, a_screenshot_is_found_by_its_content) {
    const Layout& layout = *layout_named(GetParam().layout);
    const Picture strip = to_picture(identity_cube(GetParam().size), layout);
    Picture shot = screenshot(strip.width + 80, strip.height + 120);
    put(shot, strip, {31, 67});
    const Picture upright = graded(in_codes(shot), warm_look());
    const bool all = !support::is_sanitized && GetParam().size == 16 &&
                     (layout.name == "strip" || layout.name == "hald");
    const std::vector<Turn> turns = all ? all_turns() : std::vector<Turn>{{1, false}};
    for (const Turn turn : turns) {
        const Picture picture = turned(upright, turn);
        const std::vector<FoundStrip> found = find_strips(picture);
        ASSERT_EQ(found.size(), 1U) << words_of(turn);
        const FoundStrip& one = found.front();
        EXPECT_EQ(one.framed.size, GetParam().size) << words_of(turn);
        EXPECT_LT(off_from(lattice_in(turned(picture, one.turn), one), warm_look()),
                  rounded_to_8_bits)
            << words_of(turn) << " " << one.framed.layout->name;
    }
}

TEST(BareStripIn, a_photograph_is_none) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    EXPECT_TRUE(find_strips(screenshot(640, 360)).empty());
    EXPECT_TRUE(find_strips(noisy(screenshot(400, 300), 3)).empty());
}

TEST(BareStripIn, a_picture_of_two_is_found_twice_and_a_pixel_chooses) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    Picture shot = screenshot(400, 200);
    const Picture strip = to_picture(identity_cube(16), *layout_named("strip"));
    put(shot, strip, {20, 30});
    put(shot, graded(strip, warm_look()), {90, 120});
    ASSERT_EQ(find_strips(shot).size(), 2U);
    const std::vector<FoundStrip> chosen = find_strips(shot, {.around = Pixel{100, 125}});
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_EQ(chosen[0].at, (Pixel{90, 120}));
}

} // namespace
} // namespace lutlib
