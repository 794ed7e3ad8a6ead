// Several pictures, folders and sequences through apply.
#include "tests/converter/run_program.h"

#include "converter/progress.h"
#include "lutlib/io/image.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

extern char** environ;

namespace converter_test {
namespace {

namespace fs = std::filesystem;
namespace io = lutlib::io;
using Names = std::vector<std::string>;
using nlohmann::json;

// Frames that differ, each `side` pixels high and wide.
void write_frames(const Folder& folder, int first, int last, int side = 16,
                  const std::string& extension = ".png") {
    for (int frame = first; frame <= last; ++frame) {
        io::FloatImage image;
        image.width = image.height = side;
        std::uint32_t noise = static_cast<std::uint32_t>(frame);
        for (int i = 0; i < side * side * 3; ++i) {
            noise = noise * 1664525 + 1013904223;
            image.rgba.push_back(static_cast<float>(noise >> 24) / 255);
            if (i % 3 == 2) {
                image.rgba.push_back(1);
            }
        }
        io::write_image(folder.path("s." + std::to_string(frame) + extension), image,
                        {.depth = extension == ".png" ? io::Depth::uint8 : io::Depth::half,
                         .alpha = false,
                         .text = {}});
    }
}

class ManyPictures : public testing::Test {
  protected:
    Result apply(const Names& words) const {
        Names all{"apply", look_};
        all.insert(all.end(), words.begin(), words.end());
        return lutconv(all);
    }
    Names made() const { return names_in(folder_.path("out")); }

    Folder folder_;
    std::string look_ = folder_.write("look.cube", saturated_cube(9));
    std::string pattern_ = folder_.path("s.####.png");
    std::string out_ = folder_.path("out/{name}.{ext}");
};

TEST_F(ManyPictures, of_a_pattern_are_what_each_is_by_itself) {
    write_frames(folder_, 998, 1002);
    const Result result = apply({folder_.path("s.%d.png"), "-o", folder_.path("out/g.####.png")});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("5 pictures -> "), std::string::npos) << result.out;
    EXPECT_EQ(made(),
              (Names{"g.0998.png", "g.0999.png", "g.1000.png", "g.1001.png", "g.1002.png"}));
    for (const int frame : {998, 1002}) {
        const std::string one = folder_.path("one.png");
        ASSERT_EQ(apply({folder_.path("s." + std::to_string(frame) + ".png"), "-o", one}).exit_code,
                  0);
        EXPECT_EQ(contents(one),
                  contents(folder_.path(frame == 998 ? "out/g.0998.png" : "out/g.1002.png")));
    }
}

TEST_F(ManyPictures, come_from_folders_and_paths_into_a_folder) {
    fs::create_directory(folder_.path("in"));
    write_frames(folder_, 1001, 1002);
    fs::rename(folder_.path("s.1001.png"), folder_.path("in/a.png"));
    folder_.write("in/readme.txt", "x");
    const Result result =
        apply({folder_.path("in"), folder_.path("s.1002.png"), "-o", folder_.path("out/")});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(made(), (Names{"a.png", "s.1002.png"}));
    EXPECT_NE(result.err.find("left out 1 file of types"), std::string::npos) << result.err;
}

TEST_F(ManyPictures, with_a_bad_one_among_them_are_made_but_for_that) {
    write_frames(folder_, 1001, 1004);
    folder_.write("s.1002.png", contents(folder_.path("s.1002.png")).substr(0, 300));
    const Result result = apply({pattern_, "-o", out_, "--frames", "1001-1005", "--json"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(made(), (Names{"s.1001.png", "s.1003.png", "s.1004.png"}));
    const json said = json::parse(result.out);
    EXPECT_EQ(said["pictures"].size(), 3U);
    EXPECT_EQ(said["pictures"][1]["picture"], folder_.path("s.1003.png"));
    ASSERT_EQ(said["failed"].size(), 2U);
    EXPECT_EQ(said["failed"][0]["picture"], folder_.path("s.1002.png"));
    EXPECT_EQ(said["failed"][1]["picture"], folder_.path("s.1005.png"));
    EXPECT_NE(result.err.find("s.1002.png: "), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2) << result.err;
}

TEST_F(ManyPictures, that_are_there_and_newer_than_all_they_come_from_are_left_by_resume) {
    write_frames(folder_, 1001, 1003);
    const std::string recipe = folder_.write(
        "look.json", R"({"schema_version": 1, "base": "look.cube", "operators": []})");
    look_ = recipe;
    const auto resumed = [&] { return apply({pattern_, "-o", out_, "--resume", "--json"}); };
    const auto age = [&](const std::string& name, int seconds) {
        fs::last_write_time(folder_.path(name),
                            fs::file_time_type::clock::now() - std::chrono::seconds(seconds));
    };
    for (const char* const name :
         {"look.json", "look.cube", "s.1001.png", "s.1002.png", "s.1003.png"}) {
        age(name, 100);
    }
    json said = json::parse(resumed().out);
    ASSERT_EQ(said["pictures"].size(), 3U) << said;
    said = json::parse(resumed().out);
    EXPECT_EQ(said["pictures"].size(), 0U);
    EXPECT_EQ(said["were_there"], 3);
    fs::remove(folder_.path("out/s.1001.png"));
    folder_.write("out/s.1002.png", "");
    age("out/s.1003.png", 200);
    said = json::parse(resumed().out);
    EXPECT_EQ(said["pictures"].size(), 3U);
    for (const char* const name : {"look.json", "look.cube"}) {
        age(name, -100);
        EXPECT_EQ(json::parse(resumed().out)["pictures"].size(), 3U) << name << " was changed";
        age(name, 100);
    }
    age("s.1002.png", -100);
    said = json::parse(resumed().out);
    ASSERT_EQ(said["pictures"].size(), 1U);
    EXPECT_EQ(said["pictures"][0]["picture"], folder_.path("s.1002.png"));
    EXPECT_NE(apply({pattern_, "-o", out_, "--resume"}).out.find("  2 more were there already\n"),
              std::string::npos);
}

TEST_F(ManyPictures, that_are_missing_are_listed_and_not_made) {
    write_frames(folder_, 1001, 1003);
    const Result none = apply({pattern_, "-o", out_, "--missing"});
    EXPECT_EQ(none.exit_code, 1);
    EXPECT_NE(none.out.find("0 of 3 pictures there\n"), std::string::npos) << none.out;
    EXPECT_FALSE(fs::exists(folder_.path("out")));
    ASSERT_EQ(apply({pattern_, "-o", out_}).exit_code, 0);
    // Else it may be of the same moment.
    for (const char* const name : {"look.cube", "s.1001.png", "s.1002.png", "s.1003.png"}) {
        fs::last_write_time(folder_.path(name),
                            fs::file_time_type::clock::now() - std::chrono::seconds(10));
    }
    EXPECT_EQ(apply({pattern_, "-o", out_, "--missing"}).exit_code, 0);
    fs::remove(folder_.path("out/s.1002.png"));
    const Result one = apply({pattern_, "-o", out_, "--missing", "--json"});
    EXPECT_EQ(one.exit_code, 1);
    EXPECT_EQ(json::parse(one.out)["missing"], json::array({folder_.path("out/s.1002.png")}));
    EXPECT_EQ(json::parse(one.out)["were_there"], 2);
}

TEST_F(ManyPictures, of_all_shards_are_all_once) {
    write_frames(folder_, 1001, 1005);
    std::size_t count = 0;
    for (const char* const shard : {"1/3", "2/3", "3/3"}) {
        const Result result = apply({pattern_, "-o", out_, "--shard", shard, "--json"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        count += json::parse(result.out)["pictures"].size();
    }
    EXPECT_EQ(count, 5U);
    EXPECT_EQ(made().size(), 5U);
    EXPECT_EQ(apply({pattern_, "-o", out_, "--shard", "6/7"}).exit_code, 0);
    for (const char* const shard : {"0/3", "4/3", "1", "1/", "/", "1/0", "a/b", "-1/3", "1/3/5"}) {
        EXPECT_EQ(apply({pattern_, "-o", out_, "--shard", shard}).exit_code, 3) << shard;
    }
}

TEST_F(ManyPictures, to_one_name_are_refused_before_anything_is_read) {
    write_frames(folder_, 1001, 1002);
    look_ = folder_.path("no look.cube");
    const Names before = folder_.names();
    for (const char* const name : {"one.png", "{nmae}.png", "-"}) {
        const std::string output = *name == '-' ? name : folder_.path(name);
        const Result result = apply({pattern_, "-o", output});
        EXPECT_EQ(result.exit_code, 3) << name;
        EXPECT_NE(result.err.find("would both be written"), std::string::npos) << result.err;
    }
    const Result onto = apply({pattern_, "-o", folder_.path("s.1001.png"), "--frames", "1002"});
    EXPECT_EQ(onto.exit_code, 2) << "one picture may take another's place";
    EXPECT_EQ(folder_.names(), before);
}

TEST_F(ManyPictures, are_the_same_whatever_is_worked_on_at_once) {
    write_frames(folder_, 1001, 1006, 24, ".exr");
    const std::string frames = folder_.path("s.####.exr");
    const auto all = [&](const std::string& to, const Names& options) {
        Names words{frames, "-o", folder_.path(to + "/{name}.{ext}"), "-v"};
        words.insert(words.end(), options.begin(), options.end());
        const Result result = apply(words);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(result.out.find("(6 of 6)\n"), std::string::npos) << result.out;
        EXPECT_EQ(result.err, "") << "a pipe gets no bar";
        std::string bytes;
        for (const std::string& name : names_in(folder_.path(to))) {
            bytes += name + contents(folder_.path(to + "/" + name));
        }
        return bytes;
    };
    const std::string one = all("one", {"--jobs", "1"});
    EXPECT_EQ(all("many", {"--jobs", "7"}), one);
    EXPECT_EQ(all("tight", {"--jobs", "7", "--memory", "1"}), one);
}

// A limit on a file's size fails as a full disk does, by an error of write().
TEST_F(ManyPictures, on_a_full_disk_are_whole_or_not_there) {
    write_frames(folder_, 1001, 1001, 16);
    write_frames(folder_, 1002, 1003, 300);
    write_frames(folder_, 1004, 1004, 16);
    struct rlimit before {};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    struct rlimit small = before;
    small.rlim_cur = 20000;
    const auto handler = signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const Result result = lutconv_process({"apply", look_, pattern_, "-o", out_});
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, handler);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("cannot write"), std::string::npos) << result.err;
    EXPECT_EQ(made(), (Names{"s.1001.png", "s.1004.png"})) << "nor is any rest left";
}

TEST_F(ManyPictures, when_killed_are_whole_and_resume_makes_the_others) {
    write_frames(folder_, 1001, 1040, 160);
    ASSERT_EQ(apply({pattern_, "-o", folder_.path("whole/{name}.{ext}")}).exit_code, 0);
    fs::create_directory(folder_.path("out"));
    Names words{LUTCONV, "apply", look_, pattern_, "-o", out_, "--jobs", "3"};
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    ASSERT_EQ(posix_spawn(&child, LUTCONV, &files, nullptr, argv.data(), environ), 0);
    posix_spawn_file_actions_destroy(&files);
    while (made().size() < 6 && waitpid(child, nullptr, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    std::size_t finished = 0;
    for (const std::string& name : made()) {
        if (name.front() != '.') {
            ++finished;
            EXPECT_EQ(contents(folder_.path("out/" + name)),
                      contents(folder_.path("whole/" + name)));
        }
    }
    EXPECT_GE(finished, 1U);
    const Result rest = apply({pattern_, "-o", out_, "--resume", "--json"});
    ASSERT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(json::parse(rest.out)["were_there"], finished);
    for (const std::string& name : names_in(folder_.path("whole"))) {
        EXPECT_EQ(contents(folder_.path("out/" + name)), contents(folder_.path("whole/" + name)));
    }
}

TEST(ProgressText, says_how_far_how_fast_and_how_long) {
    EXPECT_EQ(converter::progress_text(0, 4, "pictures", 0),
              "[------------------------] 0/4 pictures");
    EXPECT_EQ(converter::progress_text(1, 4, "pictures", 2),
              "[######------------------] 1/4 pictures, 0.5/s, 0:06 left");
    EXPECT_EQ(converter::progress_text(1, 7201, "looks", 1),
              "[------------------------] 1/7201 looks, 1/s, 2:00:00 left");
}

} // namespace
} // namespace converter_test
