// Every #include of the repository keeps to the table of which part may use which.
#include "tests/structure/include_rules.h"

#include <gtest/gtest.h>

namespace structure {
namespace {

std::string lines_of(const std::vector<std::string>& lines) {
    std::string out;
    for (const std::string& line : lines) {
        out += line + "\n";
    }
    return out;
}

TEST(IncludeRules, hold_for_every_line_of_the_repository) {
    const Sources sources = read_sources(LUT_SOURCE_FOLDER);
    ASSERT_TRUE(sources.contains("lutlib/lut.h"));
    ASSERT_TRUE(sources.contains("preview/main.cpp"));
    EXPECT_EQ(lines_of(faults(parts(), sources)), "");
}

TEST(IncludeRules, let_arrows_go_one_way) {
    EXPECT_EQ(circle_in(parts()), "");
    EXPECT_EQ(circle_in({{"a", {"b"}}, {"b", {"c"}}, {"c", {"a"}}}), "a -> b -> c -> a");
}

TEST(IncludeRules, name_the_file_and_line_that_offends) {
    const std::vector<Part> table{{"low", {}}, {"high", {"low"}}};
    EXPECT_EQ(lines_of(faults(table, {{"low/a.h", "#pragma once\n"},
                                      {"high/b.cpp", "#include \"low/a.h\"\n"}})),
              "");
    EXPECT_EQ(lines_of(faults(table, {{"low/a.cpp", "// A.\n#include <map>\n"
                                                    " #  include \"high/b.h\"\n"},
                                      {"high/b.h", "#include \"low/gone.h\"\n"},
                                      {"new/c.h", ""}})),
              "high/b.h:1: includes low/gone.h, which is no file of the repository\n"
              "low/a.cpp:3: includes high/b.h, which low may not\n"
              "new/c.h:1: its folder is not in the table of parts\n");
}

TEST(IncludeRules, a_file_may_have_a_row_of_its_own) {
    const std::vector<Part> table{{"low", {}}, {"low/plain.*", {}}, {"high", {"low/plain.*"}}};
    EXPECT_EQ(lines_of(faults(table, {{"low/plain.h", ""},
                                      {"low/other.h", ""},
                                      {"high/b.h", "#include \"low/plain.h\"\n"
                                                   "#include \"low/other.h\"\n"}})),
              "high/b.h:2: includes low/other.h, which high may not\n");
}

TEST(IncludeRules, find_what_is_reached_through_others) {
    const std::vector<Part> table{{"low", {}}, {"high", {"low"}, {"vulkan/"}}};
    EXPECT_EQ(lines_of(faults(table, {{"low/a.h", "#include <vulkan/vulkan.h>\n"},
                                      {"high/b.h", "#include \"low/a.h\"\n"}})),
              "high/b.h:1: reaches <vulkan/...>: high/b.h -> low/a.h -> <vulkan/vulkan.h>\n");
}

} // namespace
} // namespace structure
