// What lutpreview itself prints, as a program that people and programs start.
#include "lutlib/version.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

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
                                   "\nOpenColorIO 2.", "\nOpenImageIO 2."}) {
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

std::string contents_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// A flat grey of 188, which is half of white's light.
TEST(Scope, writes_its_counts_in_the_encoding_that_is_asked_for) {
    const std::string picture = testing::TempDir() + "grey.ppm",
                      path = testing::TempDir() + "counts.csv";
    std::ofstream(picture, std::ios::binary) << "P6\n4 3\n255\n" << std::string(36, '\xbc');
    const std::string run = picture + " --headless -o " + path + " --scope-size 64x64 --scope ";
    EXPECT_EQ(lutpreview(run + "rgb 2>/dev/null"), "");
    EXPECT_TRUE(contents_of(path).starts_with("channel,column,level,value (%),count\n"
                                              "red,0,188,73.7255,3\nred,1,188,73.7255,3\n"))
        << contents_of(path);
    EXPECT_EQ(lutpreview(run + "waveform --scope-encoding pq --display-white 200 2>/dev/null"), "");
    EXPECT_TRUE(contents_of(path).starts_with("channel,column,level,value (cd/m2),count\n"
                                              "luma,0,130,101."))
        << contents_of(path);
    // The picture's own codes are PQ: they stay.
    EXPECT_EQ(lutpreview(run + "waveform --scope-encoding pq --picture-encoding pq 2>/dev/null"),
              "");
    EXPECT_TRUE(contents_of(path).starts_with("channel,column,level,value (cd/m2),count\n"
                                              "luma,0,188,"))
        << contents_of(path);
    EXPECT_NE(lutpreview(picture + " --explain --scope rgb --scope-encoding hlg 2>&1")
                  .find("levels are hlg of the shown srgb; figures are per cent"),
              std::string::npos);
    std::remove(picture.c_str());
    std::remove(path.c_str());
}

/// Its exit code.
int status_of(const std::string& arguments) {
    const int status = std::system((std::string(LUTPREVIEW) + " " + arguments).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Meter, says_the_exposure_that_it_has_found_and_where_there_is_no_light) {
    const std::string path = testing::TempDir() + "metered.png", given = " --headless -o " + path;
    const std::string said =
        lutpreview("studio --size 64x36 --meter all --shadow-size 64" + given + " 2>&1");
    EXPECT_TRUE(said.starts_with("lutpreview: metered: --exposure ")) << said;
    EXPECT_EQ(lutpreview("studio --size 64x36 --meter 64,0" + given + " 2>&1"),
              "lutpreview: --meter needs X,Y within the picture of 64x36, got '64,0'\n");
    EXPECT_EQ(lutpreview(path + " --meter all --headless -o " + testing::TempDir() +
                         "metered_twice.png 2>&1"),
              "lutpreview: --meter changes nothing here: the picture is display-encoded already\n");
}

TEST(Report, refuses_what_says_two_things_or_nothing) {
    const auto refused = [](const std::string& arguments) {
        return lutpreview("report plain --size 32x18 " + arguments + " 2>&1");
    };
    EXPECT_NE(refused("").find("report needs -o FILE"), std::string::npos);
    EXPECT_NE(refused("--json --csv").find("report needs -o FILE"), std::string::npos);
    EXPECT_NE(refused("-o x.json --json").find("let it end in .html"), std::string::npos);
    EXPECT_NE(refused("-o x.html --budget-ms 1 --max-delta-e 1").find("drop one of them"),
              std::string::npos);
    EXPECT_NE(refused("-o x.html --passes blom").find("did you mean bloom?"), std::string::npos);
    EXPECT_NE(lutpreview("report plain --size 8x8 -o x.html 2>&1").find("at least 16x16"),
              std::string::npos);
}

TEST(Report, writes_its_page_and_figures) {
    const std::string stem = testing::TempDir() + "program_report";
    const std::string run = "report plain --passes lookups,surfaces --size 32x18 ";
    const std::string text = lutpreview(run + "-o " + stem + ".html --json --csv 2>/dev/null");
    EXPECT_NE(text.find("tetrahedral"), std::string::npos) << text;
    for (const char* const ending : {".html", ".json", ".csv"}) {
        std::ifstream file(stem + ending);
        const std::string bytes((std::istreambuf_iterator<char>(file)), {});
        EXPECT_NE(bytes.find("tetrahedral"), std::string::npos) << ending;
        std::remove((stem + ending).c_str());
    }
    const std::string csv = lutpreview(run + "--csv 2>/dev/null");
    EXPECT_TRUE(csv.starts_with("study,input,width,height,variant,")) << csv;
}

TEST(Check, prints_what_it_finds_and_says_by_its_exit_code_whether_all_holds) {
    const std::string small = "check chart --size 16x9 --without shadows ";
    const auto report = nlohmann::json::parse(lutpreview(small + "--json 2>/dev/null"));
    EXPECT_TRUE(report["passed"].get<bool>());
    EXPECT_GT(report["extremes"].size(), 80U);
    EXPECT_GT(report["planted"].size(), 5U);
    for (const auto& row : report["extremes"]) {
        EXPECT_EQ(row["behind_resolve"], 0) << row["name"];
    }
    // A microsecond later the glitch is another.
    const std::string stiff = small + "--effect glitch:strength=1,rate=10 --time 0.0999995 ";
    EXPECT_EQ(status_of(stiff + "--quiet >/dev/null"), 1);
}

class Outputs : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = testing::TempDir() + "outputs_XXXXXX";
        folder_ = mkdtemp(pattern.data());
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string bytes(const std::string& name) const {
        std::ifstream in(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// A picture that needs no GPU, to a file.
    std::string drawing(const std::string& name) const {
        return "--cube-view a --a " LUT_LOOKS_FOLDER "/warm_teal.cube --size 64x48 -o " +
               path(name) + " ";
    }

    std::filesystem::path folder_;
};

TEST_F(Outputs, are_whole_whatever_standard_streams_are_closed) {
    ASSERT_EQ(status_of(drawing("open.png")), 0);
    for (const char* const streams : {"<&- >&- 2>&-", ">&- 2>/dev/null", "<&- 2>&- >/dev/null"}) {
        EXPECT_EQ(status_of(drawing("closed.png") + streams), 0) << streams;
        EXPECT_EQ(bytes("closed.png"), bytes("open.png")) << streams;
    }
}

TEST_F(Outputs, that_are_full_are_an_error) {
    for (const char* const words : {"--list", "--help", "--version"}) {
        EXPECT_EQ(status_of(std::string(words) + " >/dev/full 2>/dev/null"), 2) << words;
    }
    for (const char* const name : {"x.png", "x.exr", "x.jpg", "x.tif"}) {
        std::filesystem::create_symlink("/dev/full", path(name));
        EXPECT_EQ(status_of(drawing(name) + "2>" + path("said")), 2) << name;
        EXPECT_NE(bytes("said").find("No space left on device"), std::string::npos)
            << bytes("said");
        EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << name;
    }
}

TEST_F(Outputs, that_name_what_is_read_are_refused) {
    std::filesystem::copy_file(LUT_LOOKS_FOLDER "/warm_teal.cube", path("x.cube"));
    const std::string before = bytes("x.cube");
    for (const char* const mode : {"--cube-view a --a ", "plain --headless --a "}) {
        EXPECT_EQ(status_of(mode + path("x.cube") + " -o " + path("x.cube") + " 2>" + path("said")),
                  3);
        EXPECT_NE(bytes("said").find("-o names a look that is shown itself"), std::string::npos)
            << bytes("said");
        EXPECT_EQ(bytes("x.cube"), before);
    }
}

TEST_F(Outputs, that_go_into_an_engines_folder_need_one_before_a_window_opens) {
    const auto said_of = [&](const std::string& folder) {
        EXPECT_EQ(status_of("plain --watch-engine-folder '" + folder + "' 2>" + path("said")), 2);
        return bytes("said");
    };
    std::ofstream(path("file")) << "x";
    for (const std::string& folder : {path("gone"), path("file"), std::string()}) {
        const std::string said = said_of(folder);
        EXPECT_NE(said.find("make the engine's folder first"), std::string::npos) << said;
        EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    }
    if (::geteuid() != 0) { // who may write everywhere
        std::filesystem::create_directory(path("closed"));
        std::filesystem::permissions(path("closed"), std::filesystem::perms::owner_read);
        EXPECT_NE(said_of(path("closed")).find("Permission denied"), std::string::npos);
    }
}

TEST_F(Outputs, of_a_program_that_is_killed_are_the_old_or_the_whole_new_file) {
    ASSERT_EQ(status_of(drawing("new.png")), 0);
    const std::string whole = bytes("new.png");
    for (int hundredths = 0; hundredths < 10; ++hundredths) {
        std::ofstream(path("x.png"), std::ios::binary) << "old";
        status_of(drawing("x.png") + "& sleep 0.0" + std::to_string(hundredths) +
                  "; kill -9 $! 2>/dev/null; wait 2>/dev/null");
        const std::string found = bytes("x.png");
        EXPECT_TRUE(found == "old" || found == whole) << found.size() << " bytes";
    }
    ASSERT_EQ(status_of(drawing("x.png")), 0);
    const auto count = std::distance(std::filesystem::directory_iterator(folder_), {});
    EXPECT_EQ(count, 2) << "what a killed program left is still there";
}

} // namespace
