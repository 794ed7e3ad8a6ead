// What is installed for other programs includes nothing that is not.
#include "lutlib/version.h"
#include "tests/structure/include_rules.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

namespace structure {
namespace {

std::set<std::string> public_headers() {
    std::ifstream list(LUT_SOURCE_FOLDER "/lutlib/public_headers.cmake");
    const std::regex header(R"(^ *(lutlib/\S+\.h)$)");
    std::set<std::string> out;
    for (std::string line; std::getline(list, line);) {
        if (std::smatch found; std::regex_match(line, found, header)) {
            out.insert(found[1]);
        }
    }
    return out;
}

// Those of `text` that a program with nothing but the installed headers and a system lacks.
std::string missing_includes(const std::string& text, const std::set<std::string>& installed) {
    const std::regex include(R"((?:^|\n)#include ([<"])([^>"]+))");
    std::string out;
    for (std::sregex_iterator at(text.begin(), text.end(), include), end; at != end; ++at) {
        const std::string name = (*at)[2];
        const bool is_ours = (*at)[1] == "\"";
        const bool is_of_system =
            name.find('.') == std::string::npos || name == "unistd.h" || name.starts_with("sys/");
        if (is_ours ? !installed.contains(name) : !is_of_system) {
            out += " " + name;
        }
    }
    return out;
}

TEST(PublicHeaders, include_only_each_other_and_the_system) {
    const Sources sources = read_sources(LUT_SOURCE_FOLDER);
    const std::set<std::string> installed = public_headers();
    ASSERT_TRUE(installed.contains("lutlib/bake/bake.h"));
    for (const std::string& header : installed) {
        ASSERT_TRUE(sources.contains(header)) << header;
        EXPECT_EQ(missing_includes(sources.at(header), installed), "") << header;
    }
    EXPECT_EQ(
        missing_includes("#include <vector>\n#include \"lutlib/gone.h\"\n#include <fmt/core.h>",
                         installed),
        " lutlib/gone.h fmt/core.h");
}

TEST(PublicHeaders, say_the_version_once_as_numbers_and_once_as_text) {
    EXPECT_EQ(lutlib::version, std::to_string(LUTLIB_VERSION_MAJOR) + "." +
                                   std::to_string(LUTLIB_VERSION_MINOR) + "." +
                                   std::to_string(LUTLIB_VERSION_PATCH));
}

} // namespace
} // namespace structure
