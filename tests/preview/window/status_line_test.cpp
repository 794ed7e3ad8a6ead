// What the line under the picture has in windows of every width.
#include "preview/panels/status_line.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace preview::panels {
namespace {

constexpr Probe probe{{1, 0.5, 0}, {1, 0.5, 0}, {0, 0.5, 1}, {1, 1, 1}};

/// As wide as all its characters.
float width_of(const StatusForm& form) {
    std::size_t characters = 0;
    for (const StatusPart& part : status_parts(form, {12, 345}, probe)) {
        characters += part.text.size() + part.values.size();
    }
    return static_cast<float>(characters);
}

std::vector<std::string> names_in(float width, bool has_a) {
    std::vector<std::string> out;
    for (const StatusPart& part :
         status_parts(status_form(width, has_a, &width_of), {12, 345}, probe)) {
        out.push_back(part.name);
    }
    return out;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(StatusLine, fits_every_width_that_holds_the_edited_side_and_always_has_that) {
    const float least = width_of(status_forms().back());
    for (const bool has_a : {false, true}) {
        std::size_t before = 0;
        for (float width = 1; width < 200; ++width) {
            const StatusForm& form = status_form(width, has_a, &width_of);
            EXPECT_TRUE(width < least || width_of(form) <= width) << width;
            EXPECT_FALSE(has_a && form.is_without_a) << width;
            const std::vector<std::string> names = names_in(width, has_a);
            EXPECT_TRUE(has(names, "B")) << width;
            EXPECT_TRUE(names.size() >= before || !has_a) << "less in more room: " << width;
            before = names.size();
        }
        EXPECT_EQ(names_in(200, has_a),
                  (std::vector<std::string>{"place", "before", "A", "B", "differences"}));
    }
}

TEST(StatusLine, has_the_difference_in_place_of_an_a_that_says_before_again) {
    const auto with_difference =
        std::find_if(status_forms().begin(), status_forms().end(),
                     [](const StatusForm& form) { return form.is_without_a; });
    ASSERT_NE(with_difference, status_forms().end());
    const float width = width_of(*with_difference);
    EXPECT_EQ(names_in(width, false), (std::vector<std::string>{"before", "B", "differences"}));
    EXPECT_FALSE(has(names_in(width, true), "differences"));
}

TEST(StatusLine, has_codes_and_values_of_each_colour) {
    const std::vector<StatusPart> parts = status_parts(status_forms().front(), {12, 345}, probe);
    ASSERT_EQ(parts.size(), 5U);
    EXPECT_EQ(parts[0].text, "  12,  345");
    EXPECT_EQ(parts[1].text, "before 255 128   0");
    EXPECT_EQ(parts[1].values, "1.0000 0.5000 0.0000");
    EXPECT_EQ(parts[1].color, &probe.before);
    EXPECT_EQ(parts[3].text, "B   0 128 255");
    EXPECT_EQ(parts[3].color, &probe.b);
    EXPECT_NE(parts[4].text.find("dE2000 A 0.00  B "), std::string::npos) << parts[4].text;
}

} // namespace
} // namespace preview::panels
