#include "lutlib/bake/fitted.h"

#include "lutlib/bake/budget.h"
#include "lutlib/metrics/samples.h"
#include "tests/lutlib/looks.h"

#include <gtest/gtest.h>

namespace lutlib {
namespace {

// A fit of 9 nodes, and what one kind of damage makes of it.
class Fitted : public testing::Test {
  protected:
    static constexpr int n = 9;
    const Engine& engine = *engine_named("piccolo");
    const Transform look = test_looks()[3].transform();
    const FilledBake& baked = baked_once();
    CodeImage picture = baked.bake.picture;

    FittedCheck check() const { return check_fitted(picture, engine, n, look); }

    static const FilledBake& baked_once() {
        static const FilledBake once =
            bake_fitted(test_looks()[3].transform(), *engine_named("piccolo"), n, 8);
        return once;
    }

    template <class F>
    void change_every(F&& change) {
        for (std::uint16_t& code : picture.samples) {
            code = static_cast<std::uint16_t>(std::clamp(change(int{code}), 0, 255));
        }
    }
};

TEST_F(Fitted, is_right_as_it_was_baked) {
    ASSERT_TRUE(baked.fitted);
    const FittedCheck found = check();
    EXPECT_TRUE(found.right());
    EXPECT_EQ(found.moved, 0U);
    EXPECT_LT(found.result.absolute.mean, found.point_sampled.absolute.mean);
}

TEST_F(Fitted, is_wrong_with_one_magenta_texel_and_says_where) {
    for (std::size_t c = 0; c < 3; ++c) {
        picture.at({40, 4}, c) = c == 1 ? 0 : 255;
    }
    const FittedCheck found = check();
    EXPECT_EQ(found.moved, 1U);
    ASSERT_FALSE(found.right());
    EXPECT_NE(found.faults.front().find("at 40,4"), std::string::npos) << found.faults.front();
}

TEST_F(Fitted, is_wrong_with_one_code_off_by_255) {
    picture.at({0, 0}, 2) = 255;
    EXPECT_FALSE(check().right());
}

TEST_F(Fitted, is_wrong_with_a_row_six_codes_too_bright) {
    for (int x = 0; x < picture.width; ++x) {
        std::uint16_t& code = picture.at({x, 0}, 0);
        code = static_cast<std::uint16_t>(std::min(code + 6, 255));
    }
    EXPECT_FALSE(check().right());
}

TEST_F(Fitted, is_wrong_when_everything_is_one_code_darker) {
    change_every([](int code) { return code - 1; });
    const FittedCheck found = check();
    EXPECT_EQ(found.moved, 0U); // rounding could explain each of them
    EXPECT_FALSE(found.right());
}

TEST_F(Fitted, is_wrong_as_a_fit_of_another_look) {
    picture = bake_fitted(test_looks()[2].transform(), engine, n, 8).bake.picture;
    EXPECT_FALSE(check().right());
}

} // namespace
} // namespace lutlib
