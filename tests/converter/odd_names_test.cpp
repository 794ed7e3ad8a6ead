// Names, titles and comments that a terminal or JSON would stumble over.
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace converter_test {
namespace {

using nlohmann::json;

TEST(OddNames, that_are_no_utf8_do_not_break_json) {
    const Folder folder;
    const std::string look =
        folder.write("caf\xe9.cube", "TITLE \"caf\xe9\"\n# \xa9 caf\xe9\n" + saturated_cube(5));
    const std::string out = folder.path("\xe9.cube"), page = folder.path("r.html"),
                      figures = folder.path("r.json"), recipe = folder.path("x.json");
    const std::string picture = folder.path("\xe9.png");
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"info", look},
             {"convert", look, "-o", out, "--title", "\xe9"},
             {"bake", look, "-o", picture},
             {"edit", "identity", "-o", out, "--title", "\xe9", "--save-recipe", recipe},
             {"resample", look, "-o", out},
             {"compare", look, out},
             {"check", look},
             {"apply", look, picture, "-o", folder.path("\xe9\xe9.png")},
             {"sheet", picture, look, "-o", folder.path("s.png")}}) {
        std::vector<std::string> words = arguments;
        words.emplace_back("--json");
        const Result result = lutconv(words);
        EXPECT_EQ(result.exit_code, 0) << arguments[0] << ": " << result.err;
        EXPECT_TRUE(json::accept(result.out)) << arguments[0] << ": " << result.out;
    }
    EXPECT_EQ(json::parse(contents(recipe))["title"], "\xef\xbf\xbd");
    const Result result = lutconv({"report", look, "--sizes", "2", "-o", page, "--json", figures});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(json::accept(contents(figures)));
}

TEST(OddNames, of_control_characters_are_escaped_for_people_and_kept_in_json) {
    const Folder folder;
    const std::string name = "a\n\x1b[2J\x7f.cube";
    const std::string look =
        folder.write(name, "TITLE \"bell \a\"\n# \x1b[31mred\n" + saturated_cube(5));
    const Result info = lutconv({"info", look});
    EXPECT_NE(info.out.find("a\\n\\x1b[2J\\x7f.cube\n"), std::string::npos) << info.out;
    EXPECT_NE(info.out.find("title: bell \\x07\n"), std::string::npos) << info.out;
    EXPECT_NE(info.out.find("# \\x1b[31mred\n"), std::string::npos) << info.out;
    EXPECT_EQ(json::parse(lutconv({"info", look, "--json"}).out)["file"], look);
    const Result missing = lutconv({"info", folder.path("b\n\x1b.cube")});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_EQ(std::count(missing.err.begin(), missing.err.end(), '\n'), 1) << missing.err;
    for (const Result& result :
         {lutconv({"convert", look, "-o", folder.path("\x1b.cube")}),
          lutconv({"bake", look, "-o", folder.path("\x1b.png")}), lutconv({"check", look}),
          lutconv({"compare", look, look}), lutconv({"info", "\x1b"}), lutconv({"\x1b"})}) {
        EXPECT_EQ((result.out + result.err).find_first_of("\x1b\x7f"), std::string::npos);
    }
}

} // namespace
} // namespace converter_test
