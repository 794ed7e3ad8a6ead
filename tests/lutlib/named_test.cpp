#include "lutlib/named.h"

#include "lutlib/error.h"

#include <gtest/gtest.h>

#include <array>

namespace lutlib {
namespace {

struct Row {
    std::string_view name;
    int value;
};
constexpr std::array<Row, 3> rows{{{"piccolo", 1}, {"unreal", 2}, {"ocio", 3}}};
constexpr std::array<const Row*, 2> pointers{&rows[0], &rows[2]};

std::string refusal(std::string_view name) {
    try {
        require_named(rows, "engine", name);
    } catch (const UsageError& error) {
        return error.message();
    }
    return {};
}

TEST(Named, finds_a_row_in_a_table_of_rows_and_of_pointers) {
    EXPECT_EQ(find_named(rows, "unreal"), &rows[1]);
    EXPECT_EQ(find_named(pointers, "ocio"), &rows[2]);
    EXPECT_EQ(find_named(pointers, "unreal"), nullptr);
    EXPECT_EQ(&require_named(rows, "engine", "ocio"), &rows[2]);
}

TEST(Named, tells_capitals_apart_unless_asked_not_to) {
    EXPECT_EQ(find_named(rows, "Unreal"), nullptr);
    EXPECT_EQ(find_named(rows, "UNREAL", Letters::any_case), &rows[1]);
    EXPECT_EQ(find_named(rows, "unrea", Letters::any_case), nullptr);
    EXPECT_EQ(&require_named(rows, "engine", "OCIO", Letters::any_case), &rows[2]);
}

TEST(Named, a_refusal_lists_what_there_is) {
    EXPECT_EQ(refusal("godot"), "there is no engine 'godot'; there are piccolo, unreal, ocio");
    EXPECT_EQ(no_such_name("suite", "soft", name_list(std::array{rows[2]})),
              "there is no suite 'soft'; there is ocio");
    EXPECT_EQ(no_such_name("light", "sun", {}), "there is no light 'sun'; there are none");
    EXPECT_EQ(names_of(pointers), "piccolo, ocio");
}

TEST(Named, a_refusal_lists_a_hundred_names_and_counts_the_rest) {
    const std::vector<std::string_view> names(130, "space");
    const std::string text = no_such_name("colour space", "another", names);
    EXPECT_TRUE(text.starts_with("there is no colour space 'another'; there are space, space"));
    EXPECT_TRUE(text.ends_with("space and 30 more")) << text;
    EXPECT_EQ(text.size(), std::string("there is no colour space 'another'; there are ").size() +
                               100 * 7 - 2 + std::string(" and 30 more").size());
}

TEST(Named, a_refusal_suggests_the_name_that_two_edits_make) {
    const std::string list = " There are piccolo, unreal, ocio";
    EXPECT_EQ(refusal("unrael"), "there is no engine 'unrael'; did you mean unreal?" + list);
    EXPECT_EQ(refusal("picolo"), "there is no engine 'picolo'; did you mean piccolo?" + list);
    EXPECT_EQ(refusal("UNREAL"), "there is no engine 'UNREAL'; did you mean unreal?" + list);
    EXPECT_EQ(refusal("oci"), "there is no engine 'oci'; did you mean ocio?" + list);
    EXPECT_EQ(refusal("uneal5"), "there is no engine 'uneal5'; did you mean unreal?" + list);
}

TEST(Named, a_refusal_suggests_nothing_that_is_three_edits_away_or_another_word) {
    EXPECT_EQ(refusal("xnrxxl").find("did you mean"), std::string::npos);
    EXPECT_EQ(refusal("oc").find("did you mean"), std::string::npos);
    EXPECT_EQ(refusal("").find("did you mean"), std::string::npos);
    EXPECT_EQ(no_such_name("axis", "x", std::array<std::string_view, 1>{"r"}),
              "there is no axis 'x'; there is r");
    EXPECT_EQ(refusal(std::string(100000, 'u')).find("did you mean"), std::string::npos);
}

} // namespace
} // namespace lutlib
