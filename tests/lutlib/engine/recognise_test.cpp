#include "lutlib/engine/recognise.h"

#include "lutlib/error.h"
#include "tests/lutlib/looks.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib {
namespace {

class RecogniseLayout : public testing::TestWithParam<Layout> {};
INSTANTIATE_TEST_SUITE_P(Layouts, RecogniseLayout,
                         testing::ValuesIn(layouts().begin(), layouts().end()),
                         [](const auto& row) { return support::test_name(row.param.name); });

TEST_P(RecogniseLayout, tells_every_look_in_this_layout_from_all_other_readings) {
    for (const int n : {16, 25, 32, 64}) {
        if (!GetParam().picture(n)) {
            continue;
        }
        for (const TestLook& look : test_looks()) {
            const Recognition found =
                recognise_one(to_picture(sampled(look.f, n), GetParam()), "look.png");
            EXPECT_EQ(found.layout->name, GetParam().name) << look.name << " " << n;
            EXPECT_EQ(found.size, n) << look.name;
        }
    }
}

TEST(Recognise, says_what_it_could_be_when_the_content_does_not_tell) {
    Lut3D grey = identity_cube(16);
    for (Rgb& node : grey.nodes) {
        node = {0.5F, 0.5F, 0.5F};
    }
    try {
        recognise_one(to_picture(grey, *layout_named("strip")), "grey.png");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(error.message().find("--engine"), std::string::npos);
        EXPECT_NE(error.message().find("strip-up of size 16"), std::string::npos);
        EXPECT_EQ(error.where().file, "grey.png");
    }
}

TEST(Recognise, refuses_dimensions_that_no_layout_has) {
    EXPECT_THROW(recognise_one(Picture{30, 20, std::vector<Rgb>(600)}, "photo.png"), Error);
}

TEST(Recognise, finds_stacked_strips) {
    const Picture one = to_picture(identity_cube(32), *layout_named("strip"));
    Picture three{one.width, 3 * one.height, {}};
    for (int i = 0; i < 3; ++i) {
        three.pixels.insert(three.pixels.end(), one.pixels.begin(), one.pixels.end());
    }
    const Recognition found = recognise_one(three, "multi.png");
    EXPECT_EQ(found.layout->name, "strip");
    EXPECT_EQ(found.rows, 3);
}

} // namespace
} // namespace lutlib
