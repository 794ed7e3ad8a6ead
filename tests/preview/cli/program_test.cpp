// What lutpreview itself prints, as a program that people and programs start.
#include "lutlib/version.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <string>

namespace {

/// Its standard output; with its standard error where the arguments end in 2>&1.
std::string lutpreview(const std::string& arguments) {
    std::string out;
    FILE* const pipe = ::popen((std::string(LUTPREVIEW) + " " + arguments).c_str(), "r");
    std::array<char, 4096> buffer{};
    for (std::size_t count = 0;
         pipe && (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        out.append(buffer.data(), count);
    }
    if (pipe) {
        ::pclose(pipe);
    }
    return out;
}

TEST(Version, names_the_program_and_what_it_uses) {
    const std::string text = lutpreview("--version");
    EXPECT_TRUE(text.starts_with("lutpreview " + std::string(lutlib::version) + "\n")) << text;
    for (const char* const part : {"\nVulkan loader 1.", "\nGLFW 3.", "\nDear ImGui 1.",
                                   "\nAssimp 5.", "\nOpenColorIO 2.", "\nOpenImageIO 2."}) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    }
    EXPECT_EQ(text.find("processes"), std::string::npos);
    EXPECT_NE(lutpreview("--version --verbose").find("processes"), std::string::npos);
}

TEST(Errors, are_json_where_json_was_asked_for) {
    const auto usage =
        nlohmann::json::parse(lutpreview("--headless --json --tonemap agz 2>/dev/null"))["error"];
    EXPECT_EQ(usage["exit_code"], 3);
    EXPECT_NE(usage["message"].get<std::string>().find("did you mean agx?"), std::string::npos);
    EXPECT_TRUE(usage["file"].is_null());
    const auto gone = nlohmann::json::parse(
        lutpreview("--headless --json --b gone.cube -o x.png 2>/dev/null"))["error"];
    EXPECT_EQ(gone["exit_code"], 2);
    EXPECT_EQ(gone["file"], "gone.cube");
    EXPECT_EQ(lutpreview("--headless --tonemap agz 2>/dev/null"), "");
}

TEST(Quiet, leaves_out_figures_and_verbose_says_what_is_written) {
    const std::string path = testing::TempDir() + "program_test.png";
    const std::string run = "plain --compare diff --size 32x18 --headless -o " + path + " ";
    EXPECT_NE(lutpreview(run + "2>/dev/null").find("dE2000"), std::string::npos);
    EXPECT_EQ(lutpreview(run + "--quiet 2>&1"), "");
    EXPECT_NE(lutpreview(run + "--quiet --json 2>/dev/null").find("difference"), std::string::npos);
    const std::string verbose = lutpreview(run + "--verbose 2>&1 >/dev/null");
    EXPECT_NE(verbose.find("lutpreview: rendered by "), std::string::npos) << verbose;
    EXPECT_NE(verbose.find("lutpreview: " + path + "\n"), std::string::npos) << verbose;
    std::remove(path.c_str());
}

} // namespace
