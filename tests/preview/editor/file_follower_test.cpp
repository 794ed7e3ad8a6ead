// Files that are read again when they change, in all the ways in which programs write them.
#include "preview/editor/file_follower.h"

#include "lutlib/io/file.h"
#include "tests/preview/editor/look_files.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace preview::editor {
namespace {

namespace fs = std::filesystem;
using lutlib::ScratchFolder;
using Clock = FileFollower::Clock;

/// What is read is kept as the title of the recipe.
FollowedFile titled_by(const std::string& path, const std::string& key = "key") {
    return {key, {path}, [path]() -> PutInPlace {
                return [text = lutlib::io::read_file(path)](History& history) {
                    history.draft().recipe.title = text;
                    return nullptr;
                };
            }};
}

class FollowedFiles : public testing::Test {
  protected:
    /// Takes what is read until it holds; false when it does not in time.
    template <class Holds>
    bool until(Holds holds) {
        const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(30);
        while (!holds() && std::chrono::steady_clock::now() < give_up) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            for (const Reread& reread : follower_.take()) {
                reason_ = reread.reason;
                if (reread.put) {
                    reread.put(history_);
                    ++times_;
                }
            }
        }
        return holds();
    }
    bool until_title(const std::string& title) {
        return until([&] { return history_.draft().recipe.title == title && reason_.empty(); });
    }
    bool until_reason(const std::string& part) {
        return until([&] { return reason_.find(part) != std::string::npos; });
    }
    /// Whether nothing is read for a while.
    bool is_still() {
        const int before = times_;
        const auto end = std::chrono::steady_clock::now() + 3 * lutlib::io::FileWatch::rest;
        until([&] { return std::chrono::steady_clock::now() > end; });
        return times_ == before;
    }
    /// A file that was written before anything was read.
    std::string old_file(const std::string& name, const std::string& text) const {
        overwrite(folder_.file(name), text);
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        return folder_.file(name);
    }

    ScratchFolder folder_;
    History history_{initial_state()};
    std::string reason_;
    int times_ = 0;
    FileFollower follower_{[] {}};
};

TEST_F(FollowedFiles, are_read_again_however_they_are_written) {
    const std::string path = old_file("a", "first");
    follower_.follow({titled_by(path)}, Clock::now());
    EXPECT_TRUE(is_still()) << "it has not changed";
    overwrite(path, "overwritten");
    EXPECT_TRUE(until_title("overwritten"));
    rename_over(path, "renamed");
    EXPECT_TRUE(until_title("renamed"));
    fs::rename(path, path + ".bak"); // as editors do that keep the old file
    overwrite(path, "beside the old one");
    EXPECT_TRUE(until_title("beside the old one"));
    fs::remove(path);
    overwrite(folder_.file("b"), "linked");
    fs::create_symlink(folder_.file("b"), path);
    EXPECT_TRUE(until_title("linked"));
    overwrite(folder_.file("b"), "through the link");
    EXPECT_TRUE(until_title("through the link"));
}

TEST_F(FollowedFiles, that_cannot_be_read_are_told_until_they_can) {
    const std::string path = old_file("a", "first");
    follower_.follow({titled_by(path)}, Clock::now());
    fs::remove(path);
    EXPECT_TRUE(until_reason("No such file"));
    overwrite(path, "");
    EXPECT_TRUE(until_reason("empty"));
    overwrite(path, "whole");
    EXPECT_TRUE(until_title("whole"));
}

TEST_F(FollowedFiles, that_are_written_in_two_steps_are_read_when_the_second_is_done) {
    const std::string path = old_file("a", "first");
    follower_.follow({titled_by(path)}, Clock::now());
    EXPECT_TRUE(is_still()); // then it is watched, and not only looked at
    {
        std::ofstream out(path, std::ios::binary);
        out << "half" << std::flush;
        EXPECT_TRUE(is_still()) << "half a file was read";
        out << " and half";
    }
    EXPECT_TRUE(until_title("half and half"));
    overwrite(path, "one");
    EXPECT_TRUE(until_title("one"));
    std::ofstream(path, std::ios::app) << " two";
    EXPECT_TRUE(until_title("one two"));
}

TEST_F(FollowedFiles, that_changed_between_their_reading_and_their_following_are_read_at_once) {
    const std::string path = old_file("a", "first");
    const Clock::time_point opened = Clock::now();
    rename_over(path, "meanwhile");
    follower_.follow({titled_by(path)}, opened);
    EXPECT_TRUE(until_title("meanwhile"));
    EXPECT_EQ(times_, 1);
    const std::string old = old_file("b", "older");
    const Clock::time_point later = Clock::now();
    timespec past[2]{{1'000'000'000, 0}, {1'000'000'000, 0}}; // written years ago, renamed now
    ASSERT_EQ(::utimensat(AT_FDCWD, old.c_str(), past, 0), 0);
    fs::rename(old, folder_.file("c"));
    follower_.follow({titled_by(folder_.file("c"), "other")}, later);
    EXPECT_TRUE(until_title("older"));
}

TEST_F(FollowedFiles, that_were_left_for_a_while_are_read_where_they_have_changed) {
    const std::string a = old_file("a", "a"), b = old_file("b", "b");
    const Clock::time_point opened = Clock::now();
    follower_.follow({titled_by(a, "a")}, opened);
    EXPECT_TRUE(is_still());
    follower_.follow({titled_by(b, "b")}, Clock::now());
    EXPECT_TRUE(is_still());
    overwrite(a, "changed");
    EXPECT_TRUE(is_still()) << "it is not followed";
    follower_.follow({titled_by(a, "a"), titled_by(b, "b")}, Clock::now());
    EXPECT_TRUE(until_title("changed"));
    EXPECT_TRUE(is_still());
    follower_.follow({titled_by(b, "b")}, Clock::now());
    follower_.follow({titled_by(a, "a"), titled_by(b, "b")}, Clock::now());
    EXPECT_TRUE(is_still()) << "it has been read since";
}

TEST_F(FollowedFiles, of_one_thing_are_each_waited_for) {
    const std::string a = old_file("a", "a"), b = old_file("b", "b");
    FollowedFile both = titled_by(a);
    both.files.push_back(b);
    follower_.follow({both}, Clock::now());
    EXPECT_TRUE(is_still());
    overwrite(b, "changed");
    EXPECT_TRUE(until([&] { return times_ == 1; }));
    overwrite(a, "changed too");
    EXPECT_TRUE(until_title("changed too"));
}

TEST_F(FollowedFiles, in_a_folder_that_may_not_be_listed_are_told) {
    if (::geteuid() == 0) {
        GTEST_SKIP() << "root lists every folder";
    }
    fs::create_directory(folder_.path() / "closed");
    const std::string path = old_file("closed/a", "first");
    fs::permissions(folder_.path() / "closed", fs::perms::owner_exec | fs::perms::owner_write);
    follower_.follow({titled_by(path)}, Clock::now());
    EXPECT_TRUE(until_reason("its folder cannot be listed"));
    fs::permissions(folder_.path() / "closed", fs::perms::owner_all);
}

TEST(FileFollower, ends_while_it_waits_and_while_it_reads) {
    const ScratchFolder folder;
    for (int i = 0; i < 20; ++i) {
        const std::string path = folder.file("a");
        overwrite(path, "first");
        FileFollower follower([] {});
        if (i > 0) {
            FollowedFile slow = titled_by(path);
            slow.read = [read = slow.read] {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                return read();
            };
            follower.follow({slow}, Clock::time_point());
            std::this_thread::sleep_for(std::chrono::milliseconds(i));
        }
    }
}

} // namespace
} // namespace preview::editor
