// --watch, as a person has it: the program runs, files change, the program is told to end.
#include "lutlib/io/watch.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

extern char** environ;

namespace converter_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

bool soon(const std::function<bool()>& holds) {
    constexpr int most = 60'000;
    for (int waited = 0; waited < most; waited += 5) {
        if (holds()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

// lutconv while it runs; what it says goes into files of a folder of its own.
class Running {
  public:
    explicit Running(Names words) {
        words.insert(words.begin(), LUTCONV);
        std::vector<char*> argv;
        for (std::string& word : words) {
            argv.push_back(word.data());
        }
        argv.push_back(nullptr);
        const std::string out = said_.path("out"), err = said_.path("err");
        constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, 1, out.c_str(), flags, 0600);
        posix_spawn_file_actions_addopen(&files, 2, err.c_str(), flags, 0600);
        EXPECT_EQ(posix_spawn(&process_, LUTCONV, &files, nullptr, argv.data(), environ), 0);
        posix_spawn_file_actions_destroy(&files);
    }
    ~Running() {
        if (process_ > 0) {
            ended_by(SIGKILL);
        }
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    std::string out() const { return contents(said_.path("out")); }
    std::string err() const { return contents(said_.path("err")); }
    // Lines on standard error that have this in them.
    std::size_t lines_with(const std::string& text) const {
        const std::string all = err();
        std::size_t count = 0;
        for (std::size_t at = all.find(text); at != std::string::npos;
             at = all.find(text, all.find('\n', at))) {
            ++count;
        }
        return count;
    }
    bool says(const std::string& text, std::size_t times) const {
        return soon([&] { return lines_with(text) >= times; });
    }
    // The exit code; -1 where a signal ended it.
    int ended_by(int signal) {
        ::kill(process_, signal);
        int status = 0;
        ::waitpid(process_, &status, 0);
        process_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

  private:
    Folder said_;
    pid_t process_ = 0;
};

std::string baked(const Folder& folder, const std::string& look) {
    const std::string png = folder.path("other.png");
    EXPECT_EQ(lutconv_in_process({"bake", look, "-o", png}).exit_code, 0);
    std::string out = contents(png);
    fs::remove(png);
    return out;
}

TEST(Watch, bakes_again_what_was_changed_broken_and_mended_until_it_is_told_to_end) {
    for (const int signal : {SIGTERM, SIGINT}) {
        const Folder folder;
        const std::string look = folder.write("look.cube", saturated_cube(5));
        const std::string png = folder.path("strip.png"), done = "look.cube -> " + png;
        Running watch({"bake", look, "-o", png, "--watch"});
        ASSERT_TRUE(watch.says(done, 1)) << watch.err();
        const std::string first = contents(png);

        folder.write("look.cube", saturated_cube(9, "TITLE \"second\"\n"));
        ASSERT_TRUE(watch.says(done, 2)) << watch.err();
        const std::string second = contents(png);
        EXPECT_NE(second, first);
        EXPECT_EQ(second, baked(folder, look));

        folder.write("look.cube", "LUT_3D_SIZE 2\n0 0 0\n1 1\n");
        ASSERT_TRUE(watch.says("look.cube:1: the table is truncated", 1)) << watch.err();
        EXPECT_EQ(contents(png), second) << "the old one stays";

        // As editors do it: written beside, and renamed over the file.
        fs::rename(folder.write("look.cube~", saturated_cube(3)), look);
        ASSERT_TRUE(watch.says(done, 3)) << watch.err();
        EXPECT_EQ(contents(png), baked(folder, look));

        EXPECT_EQ(watch.ended_by(signal), 0);
        EXPECT_EQ(folder.names(), (Names{"look.cube", "strip.png"}));
        EXPECT_EQ(watch.lines_with("lutconv: "), 4U) << watch.err();
        EXPECT_NE(watch.out().find("strip.png"), std::string::npos) << "the report";
    }
}

TEST(Watch, makes_one_bake_of_several_writes) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(3));
    Running watch({"convert", look, "-o", folder.path("out.spi3d"), "--watch", "--quiet"});
    ASSERT_TRUE(watch.says("out.spi3d", 1)) << watch.err();
    const auto start = std::chrono::steady_clock::now();
    for (int size = 3; size <= 6; ++size) {
        folder.write("look.cube", saturated_cube(size));
    }
    if (std::chrono::steady_clock::now() - start > lutlib::io::FileWatch::rest) {
        GTEST_SKIP() << "this machine has too much to do for writes in quick succession";
    }
    ASSERT_TRUE(watch.says("out.spi3d", 2)) << watch.err();
    EXPECT_NE(contents(folder.path("out.spi3d")).find("\n6 6 6\n"), std::string::npos);
    // A file that nobody reads, and one that somebody else writes next to it.
    folder.write("other.cube", saturated_cube(3));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_EQ(watch.lines_with("lutconv: "), 2U) << watch.err();
    EXPECT_EQ(watch.out(), "");
}

TEST(Watch, waits_for_the_base_of_a_recipe_and_for_one_that_it_names_later) {
    const Folder folder;
    folder.write("a.cube", saturated_cube(3));
    folder.write("b.cube", saturated_cube(5));
    const auto recipe = [&](const std::string& base) {
        return folder.write("look.json", R"({"schema_version": 1, "base": ")" + base +
                                             R"(", "operators": [{"op": "exposure"}]})");
    };
    const std::string look = recipe("a.cube"), png = folder.path("x.png");
    Running watch({"bake", look, "-o", png, "--watch"});
    ASSERT_TRUE(watch.says("-> ", 1)) << watch.err();
    folder.write("a.cube", "no look");
    ASSERT_TRUE(watch.says("look.json: ", 1)) << "the line names the input: " << watch.err();
    EXPECT_EQ(watch.lines_with("a.cube"), 1U) << "and the file that is broken: " << watch.err();
    folder.write("a.cube", saturated_cube(4));
    ASSERT_TRUE(watch.says("-> ", 2)) << watch.err();
    recipe("b.cube");
    ASSERT_TRUE(watch.says("-> ", 3)) << watch.err();
    folder.write("b.cube", saturated_cube(6));
    ASSERT_TRUE(watch.says("-> ", 4)) << watch.err();
    EXPECT_EQ(contents(png), baked(folder, look));
    // It would now read what it writes, and must not do so for ever.
    recipe("x.png");
    ASSERT_TRUE(watch.says("is an input too", 1)) << watch.err();
    recipe(std::string(300, 'x') + "/base.cube"); // which no folder can be called
    ASSERT_TRUE(watch.says("xxxx", 1)) << watch.err();
    recipe("b.cube");
    ASSERT_TRUE(watch.says("-> ", 5)) << watch.err();
    EXPECT_EQ(watch.ended_by(SIGTERM), 0);
}

TEST(Watch, of_a_folder_bakes_new_looks_and_only_what_has_changed) {
    const Folder folder;
    fs::create_directory(folder.path("looks"));
    folder.write("looks/a.cube", saturated_cube(3));
    folder.write("looks/b.cube", saturated_cube(3));
    Running watch({"bake", folder.path("looks"), "-o", folder.path("out/{name}.png"), "--watch"});
    ASSERT_TRUE(watch.says("-> ", 2)) << watch.err();
    folder.write("looks/b.cube", saturated_cube(4));
    ASSERT_TRUE(watch.says("b.cube -> ", 2)) << watch.err();
    folder.write("looks/c.cube", saturated_cube(5));
    ASSERT_TRUE(watch.says("c.cube -> ", 1)) << watch.err();
    EXPECT_EQ(names_in(folder.path("out")), (Names{"a.png", "b.png", "c.png"}));
    EXPECT_EQ(watch.lines_with("a.cube -> "), 1U) << watch.err();
    EXPECT_EQ(watch.ended_by(SIGTERM), 0);
}

TEST(Watch, of_stacked_looks_makes_the_picture_again_when_one_changes) {
    const Folder folder;
    const std::string a = folder.write("a.cube", saturated_cube(3));
    const std::string b = folder.write("b.cube", saturated_cube(3));
    const std::string png = folder.path("x.png");
    Running watch({"bake", a, b, "--stack", "-o", png, "--watch"});
    ASSERT_TRUE(watch.says("b.cube -> ", 1)) << watch.err();
    const std::string first = contents(png);
    folder.write("b.cube", saturated_cube(2));
    ASSERT_TRUE(watch.says("b.cube -> ", 2)) << watch.err();
    EXPECT_NE(contents(png), first);
    EXPECT_EQ(watch.ended_by(SIGTERM), 0);
}

TEST(Watch, ends_a_bake_that_takes_long_and_leaves_no_file_of_it) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(33));
    Running watch({"bake", look, "-o", folder.path("x.png"), "--fit", "--size", "32", "--watch"});
    ASSERT_TRUE(watch.says("-> ", 1)) << watch.err();
    folder.write("look.cube", saturated_cube(32));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(watch.ended_by(SIGINT), 0);
    for (const std::string& name : folder.names()) {
        EXPECT_TRUE(name == "look.cube" || name == "x.png") << name;
    }
}

TEST(Watch, is_refused_in_a_sentence_where_there_is_nothing_to_wait_for) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(3));
    const std::string recipe =
        folder.write("look.json", R"({"schema_version": 1, "base": "look.cube", "operators": []})");
    fs::create_directory(folder.path("looks"));
    folder.write("looks/a.cube", saturated_cube(3));
    const auto refused = [&](const Names& words, const std::string& reason) {
        Names all = words;
        all.emplace_back("--watch");
        const Result result = lutconv_in_process(all);
        EXPECT_EQ(result.exit_code, 3) << result.err;
        EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    };
    const std::string before = contents(look);
    for (const char* const verb : {"bake", "convert"}) {
        refused({verb, "-", "-o", folder.path("x.png")}, "standard input");
        refused({verb, look, "-o", "-"}, "standard output");
        refused({verb, "/dev/zero", "-o", folder.path("x.png")}, "name a file");
    }
    refused({"convert", look, "-o", look}, "name another file");
    refused({"convert", recipe, "-o", look}, "name another file");
    refused({"convert", folder.path("looks"), "-o", folder.path("looks/{name}.spi3d")},
            "write to another folder");
    refused({"bake", look, "-o", folder.path("x.jpg")}, "bake writes PNG");
    EXPECT_EQ(contents(look), before);
    EXPECT_EQ(folder.names(), (Names{"look.cube", "look.json", "looks"}));
}

} // namespace
} // namespace converter_test
