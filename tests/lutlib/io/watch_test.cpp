#include "lutlib/io/watch.h"

#include "lutlib/error.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>
#include <unistd.h>
#include <utility>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<std::string>;

void fill(const std::string& path, const std::string& text = "x") {
    std::ofstream(path) << text;
}

FileWatch watch_of(const Paths& paths) {
    FileWatch out;
    out.watch(paths);
    return out;
}

// Whether nothing is told, also after a rest.
bool is_still(FileWatch& watch) {
    std::this_thread::sleep_for(FileWatch::rest + std::chrono::milliseconds(50));
    return watch.changed().empty();
}

TEST(FileWatch, tells_writes_renames_links_and_removals) {
    const ScratchFolder folder;
    const std::string file = folder.file("a"), other = folder.file("other");
    FileWatch watch = watch_of({file});
    fill(file);
    EXPECT_EQ(watch.wait(), Paths{file}) << "it was not there";
    fill(file);
    EXPECT_EQ(watch.wait(), Paths{file});
    fill(other);
    fs::rename(other, file);
    EXPECT_EQ(watch.wait(), Paths{file});
    fs::remove(file);
    EXPECT_EQ(watch.wait(), Paths{file});
    fill(other);
    fs::create_hard_link(other, file);
    EXPECT_EQ(watch.wait(), Paths{file});
    fill(other, "reading is no change");
    std::ifstream(file).get();
    EXPECT_TRUE(is_still(watch));
}

TEST(FileWatch, tells_once_what_changes_several_times_and_only_when_it_rests) {
    const ScratchFolder folder;
    const std::string a = folder.file("a"), b = folder.file("b");
    FileWatch watch = watch_of({b, a});
    for (int i = 0; i < 5; ++i) {
        const auto start = std::chrono::steady_clock::now();
        fill(a);
        fill(b);
        const Paths told = watch.changed();
        if (std::chrono::steady_clock::now() - start < FileWatch::rest) {
            EXPECT_EQ(told, Paths{}) << "it changes still";
        }
    }
    fill(a);
    fill(b);
    EXPECT_EQ(watch.wait(), (Paths{a, b}));
    EXPECT_TRUE(is_still(watch));
}

TEST(FileWatch, tells_what_never_rests) {
    const ScratchFolder folder;
    const std::string file = folder.file("a");
    FileWatch watch = watch_of({file});
    const auto start = std::chrono::steady_clock::now();
    Paths told;
    while (told.empty() && std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) {
        fill(file);
        std::this_thread::sleep_for(FileWatch::rest / 10);
        told = watch.changed();
    }
    EXPECT_EQ(told, Paths{file});
    EXPECT_GE(std::chrono::steady_clock::now() - start, FileWatch::rest);
}

TEST(FileWatch, waits_for_the_end_of_a_long_write) {
    const ScratchFolder folder;
    const std::string file = folder.file("a");
    FileWatch watch = watch_of({file});
    std::ofstream out(file);
    out << "half" << std::flush;
    EXPECT_TRUE(is_still(watch));
    out << "whole";
    out.close();
    EXPECT_EQ(watch.wait(), Paths{file});
}

TEST(FileWatch, follows_links_and_what_they_are_turned_to) {
    const ScratchFolder folder, far;
    const std::string link = folder.file("link"), one = far.file("one"), two = far.file("two");
    fill(one);
    fill(two);
    fs::create_symlink(one, link);
    FileWatch watch = watch_of({link});
    fill(one);
    EXPECT_EQ(watch.wait(), Paths{link});
    fs::create_symlink(two, folder.file("new"));
    fs::rename(folder.file("new"), link);
    EXPECT_EQ(watch.wait(), Paths{link});
    fill(one);
    EXPECT_TRUE(is_still(watch));
    fill(two);
    EXPECT_EQ(watch.wait(), Paths{link});
}

TEST(FileWatch, waits_for_folders_that_come_go_and_are_exchanged) {
    const ScratchFolder folder;
    const std::string inner = folder.file("in"), file = folder.file("in/deep/a");
    FileWatch watch = watch_of({file});
    fs::create_directories(folder.file("in/deep"));
    EXPECT_TRUE(is_still(watch)) << "the file is not there yet";
    fill(file);
    EXPECT_EQ(watch.wait(), Paths{file});
    fs::remove_all(inner);
    EXPECT_EQ(watch.wait(), Paths{file});
    fs::create_directories(folder.file("other/deep"));
    fill(folder.file("other/deep/a"));
    fs::rename(folder.file("other"), inner);
    EXPECT_EQ(watch.wait(), Paths{file});
    fill(file);
    EXPECT_EQ(watch.wait(), Paths{file});
    fs::rename(folder.file("in/deep"), folder.file("in/away"));
    EXPECT_EQ(watch.wait(), Paths{file});
    fill(folder.file("in/away/a"));
    EXPECT_TRUE(is_still(watch)) << "another path leads there now";
}

TEST(FileWatch, of_a_folder_tells_its_files_but_hidden_ones) {
    const ScratchFolder folder;
    FileWatch watch = watch_of({folder.path().string()});
    fs::create_directory(folder.file("in"));
    fill(folder.file("in/a"));
    fill(folder.file(".hidden"));
    fill(folder.file("a"));
    fill(folder.file("b"));
    EXPECT_EQ(watch.wait(), (Paths{folder.file("a"), folder.file("b")}));
    EXPECT_TRUE(is_still(watch));
}

TEST(FileWatch, keeps_what_has_happened_to_a_path_that_is_watched_still) {
    const ScratchFolder folder;
    const std::string a = folder.file("a"), b = folder.file("b");
    FileWatch watch = watch_of({a, b});
    fill(a);
    fill(b);
    if (!watch.changed().empty()) {
        GTEST_SKIP() << "this machine has too much to do";
    }
    watch.watch(Paths{b, folder.file("c")});
    EXPECT_EQ(watch.wait(), Paths{b});
    fill(a);
    EXPECT_TRUE(is_still(watch));
}

TEST(FileWatch, is_woken_and_can_be_moved) {
    const ScratchFolder folder;
    FileWatch first = watch_of({folder.file("a")});
    FileWatch watch = std::move(first);
    watch.wake();
    EXPECT_EQ(watch.wait(), Paths{});
    std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        watch.wake();
    });
    EXPECT_EQ(watch.wait(), Paths{});
    other.join();
    fill(folder.file("a"));
    EXPECT_EQ(watch.wait(), Paths{folder.file("a")});
}

TEST(FileWatch, takes_files_of_folders_that_may_be_listed_or_are_to_come) {
    const ScratchFolder folder;
    EXPECT_TRUE(can_be_watched(folder.file("a")));
    EXPECT_TRUE(can_be_watched(folder.file("to come/a")));
    EXPECT_TRUE(can_be_watched("a"));
    EXPECT_FALSE(can_be_watched(std::string(300, 'x') + "/a"));
    if (::geteuid() != 0) { // who lists every folder
        fs::create_directory(folder.path() / "closed");
        fs::permissions(folder.path() / "closed", fs::perms::owner_exec);
        EXPECT_FALSE(can_be_watched(folder.file("closed/a")));
    }
}

TEST(FileWatch, that_cannot_be_had_says_which_folder_and_why) {
    const std::string impossible(300, 'x'); // beyond what a file system takes
    FileWatch watch;
    try {
        watch.watch(Paths{impossible + "/a"});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(impossible), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace lutlib::io
