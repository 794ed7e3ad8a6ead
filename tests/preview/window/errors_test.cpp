// What of errors is kept and shown.
#include "preview/panels/errors.h"

#include <gtest/gtest.h>

namespace preview::panels {
namespace {

std::string numbered(std::size_t number) {
    return "error " + std::to_string(number);
}

TEST(Errors, have_one_row_for_equal_ones_with_the_newest_first) {
    Errors errors;
    EXPECT_TRUE(errors.empty());
    for (const char* const text : {"a", "b", "a", "c", "a"}) {
        errors.add(text);
    }
    ASSERT_EQ(errors.rows().size(), 3U);
    EXPECT_EQ(errors.rows()[0].text, "a");
    EXPECT_EQ(errors.rows()[0].count, 3U);
    EXPECT_EQ(errors.rows()[1].text, "c");
    EXPECT_EQ(errors.rows()[2].text, "b");
    EXPECT_EQ(errors.rows()[2].count, 1U);
    errors.close(1);
    ASSERT_EQ(errors.rows().size(), 2U);
    EXPECT_EQ(errors.rows()[1].text, "b");
    errors.add("c");
    EXPECT_EQ(errors.rows()[0].count, 1U) << "one that was closed is forgotten";
}

TEST(Errors, tell_how_many_are_not_in_sight) {
    Errors errors;
    for (std::size_t i = 0; i < Errors::most_shown; ++i) {
        EXPECT_EQ(errors.more(), "");
        errors.add(numbered(i));
    }
    EXPECT_EQ(errors.more(), "");
    errors.add("one more");
    EXPECT_EQ(errors.more(), "1 older one is not shown");
    errors.add("and another");
    EXPECT_EQ(errors.more(), "2 older ones are not shown");
    errors.close(0);
    EXPECT_EQ(errors.more(), "1 older one is not shown");
}

TEST(Errors, are_kept_up_to_a_number_and_counted_beyond) {
    Errors errors;
    constexpr std::size_t beyond = 7;
    for (std::size_t i = 0; i < Errors::most_kept + beyond; ++i) {
        errors.add(numbered(i));
    }
    EXPECT_EQ(errors.rows().size(), Errors::most_kept);
    EXPECT_EQ(errors.rows().front().text, numbered(Errors::most_kept + beyond - 1));
    EXPECT_EQ(errors.rows().back().text, numbered(beyond)) << "the oldest went";
    EXPECT_EQ(errors.more(), std::to_string(Errors::most_kept + beyond - Errors::most_shown) +
                                 " older ones are not shown; the oldest are given up");
    errors.clear();
    for (std::size_t i = 0; i <= Errors::most_shown; ++i) {
        errors.add(numbered(i));
    }
    EXPECT_EQ(errors.more(), "1 older one is not shown") << "the count begins anew";
}

} // namespace
} // namespace preview::panels
