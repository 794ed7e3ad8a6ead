#include "lutlib/io/file.h"

#include "lutlib/error.h"
#include "lutlib/io/pending_file.h"
#include "lutlib/io/temporary_file.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace lutlib::io {
namespace {

namespace fs = std::filesystem;

void put(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string message_of_reading(const std::string& path, std::size_t cap = 1000) {
    try {
        read_file(path, cap);
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

TEST(ReadFile, returns_every_byte_including_nul_and_cr) {
    const ScratchFolder folder;
    const std::string bytes("a\0\r\n\xff", 5);
    put(folder.file("x"), bytes);
    EXPECT_EQ(read_file(folder.file("x")), bytes);
}

TEST(ReadFile, says_what_is_wrong_in_one_line_that_names_the_file) {
    const ScratchFolder folder;
    put(folder.file("empty"), "");
    put(folder.file("long"), std::string(1001, 'x'));
    put(folder.file("fits"), std::string(1000, 'x'));
    EXPECT_EQ(message_of_reading(folder.file("none")),
              folder.file("none") + ": cannot open the file: No such file or directory");
    EXPECT_EQ(message_of_reading(folder.path().string()),
              folder.path().string() + ": this is a directory; name a file");
    EXPECT_EQ(message_of_reading(folder.file("empty")),
              folder.file("empty") + ": the file is empty");
    EXPECT_EQ(message_of_reading(folder.file("long")),
              folder.file("long") + ": the file is larger than the limit of 1000 bytes");
    EXPECT_EQ(message_of_reading(folder.file("fits")), "no error");
}

TEST(ReadFile, refuses_devices) {
    EXPECT_EQ(message_of_reading("/dev/zero"), "/dev/zero: this is a device; name a file");
}

TEST(ReadFile, caps_a_stream_that_announces_no_size) {
    const ScratchFolder folder;
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(pipe) << std::string(2000, 'x'); });
    EXPECT_NE(message_of_reading(pipe).find("larger than the limit"), std::string::npos);
    writer.join();
}

TEST(WriteFile, replaces_the_content_and_leaves_nothing_else_behind) {
    const ScratchFolder folder;
    const std::string path = folder.file("look.cube");
    write_file(path, "first");
    write_file(path, std::string("second\0!", 8));
    EXPECT_EQ(read_file(path), std::string("second\0!", 8));
    EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFile, gives_a_new_file_the_umask_and_keeps_the_permissions_of_an_old_one) {
    const ScratchFolder folder;
    const std::string path = folder.file("x");
    const mode_t before = ::umask(0027);
    write_file(path, "1");
    ::umask(before);
    struct stat info {};
    ASSERT_EQ(::stat(path.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0640U);
    ASSERT_EQ(::chmod(path.c_str(), 0604), 0);
    write_file(path, "2");
    ASSERT_EQ(::stat(path.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0604U);
}

TEST(WriteFile, writes_through_a_symbolic_link) {
    const ScratchFolder folder;
    put(folder.file("real"), "old");
    fs::create_symlink("real", folder.file("link"));
    write_file(folder.file("link"), "new");
    EXPECT_TRUE(fs::is_symlink(folder.file("link")));
    EXPECT_EQ(read_file(folder.file("real")), "new");
}

TEST(WriteFile, writes_where_a_dangling_link_points_and_refuses_a_circle) {
    const ScratchFolder folder;
    fs::create_directory(folder.file("sub"));
    fs::create_symlink("sub/second", folder.file("first"));
    fs::create_symlink("../real", folder.file("sub/second"));
    write_file(folder.file("first"), "new");
    EXPECT_TRUE(fs::is_symlink(folder.file("first")));
    EXPECT_TRUE(fs::is_symlink(folder.file("sub/second")));
    EXPECT_EQ(read_file(folder.file("real")), "new");
    fs::create_symlink("circle", folder.file("circle"));
    EXPECT_THROW(write_file(folder.file("circle"), "x"), Error);
    EXPECT_TRUE(fs::is_symlink(folder.file("circle")));
}

TEST(WriteFile, accepts_the_longest_name_that_the_file_system_allows) {
    const ScratchFolder folder;
    const std::string path = folder.file(std::string(250, 'n') + ".cube");
    write_file(path, "x");
    EXPECT_EQ(read_file(path), "x");
}

TEST(WriteFile, refuses_a_directory_and_a_missing_folder) {
    const ScratchFolder folder;
    EXPECT_THROW(write_file(folder.path().string(), "x"), Error);
    EXPECT_THROW(write_file(folder.file("none/x"), "x"), Error);
    EXPECT_EQ(folder.count(), 0U);
}

TEST(WriteFile, writes_devices_in_place) {
    write_file("/dev/null", "x");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteFiles, replaces_all_or_none) {
    const ScratchFolder folder;
    const auto both = [&] {
        write_files(std::array{FileToWrite{folder.file("new"), "1"},
                               FileToWrite{folder.file("first"), "new"},
                               FileToWrite{folder.file("second/file"), "new"}});
    };
    put(folder.file("first"), "old");
    fs::create_directory(folder.file("second"));
    both();
    EXPECT_EQ(read_file(folder.file("first")), "new");
    EXPECT_EQ(read_file(folder.file("second/file")), "new");
    EXPECT_EQ(folder.count(), 3U);
    // One that cannot be made at all.
    put(folder.file("first"), "old");
    fs::remove(folder.file("new"));
    fs::remove_all(folder.file("second"));
    EXPECT_THROW(both(), Error);
    EXPECT_EQ(read_file(folder.file("first")), "old");
    EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFiles, puts_back_what_it_replaced_when_a_later_one_cannot_be_moved) {
    const ScratchFolder folder;
    put(folder.file("first"), "old");
    std::list<PendingFile> files;
    for (const char* const name : {"first", "new", "third"}) {
        files.emplace_back(folder.file(name));
        put(files.back().path(), "new");
    }
    fs::create_directory(folder.file("third")); // meanwhile
    EXPECT_THROW(commit_all(files), Error);
    files.clear();
    EXPECT_EQ(read_file(folder.file("first")), "old");
    EXPECT_FALSE(fs::exists(folder.file("new")));
    EXPECT_EQ(folder.count(), 2U);
}

TEST(PendingFile, removes_what_a_killed_one_for_the_same_target_left_and_nothing_that_is_at_work) {
    const ScratchFolder folder;
    const std::string path = folder.file("x.exr");
    const PendingFile at_work(path);
    put(at_work.path(), "mine");
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const PendingFile left(path);
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(folder.count(), 2U);
    {
        PendingFile next(path);
        EXPECT_EQ(folder.count(), 2U) << "the killed one's is gone, the new one's is there";
        next.commit();
    }
    EXPECT_EQ(folder.count(), 2U);
    EXPECT_EQ(read_file(at_work.path()), "mine");
}

TEST(PendingFile, refuses_a_target_that_no_file_may_replace) {
    const ScratchFolder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    EXPECT_THROW(PendingFile{folder.file("pipe")}, Error);
    EXPECT_EQ(folder.count(), 1U);
}

TEST(PendingFile, is_removed_when_it_is_not_committed) {
    const ScratchFolder folder;
    put(folder.file("x.exr"), "old");
    {
        const PendingFile pending(folder.file("x.exr"));
        EXPECT_EQ(extension_of(pending.path()), "exr");
        EXPECT_EQ(folder.count(), 2U);
    }
    EXPECT_EQ(folder.count(), 1U);
    EXPECT_EQ(read_file(folder.file("x.exr")), "old");
}

TEST(PendingFile, and_temporary_files_go_with_a_program_that_a_signal_ends) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        ::sigaction(signal, nullptr, &now);
        if (now.sa_handler == SIG_IGN) {
            continue; // as a shell's background job starts; such signals stay ignored
        }
        const ScratchFolder folder;
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            ::setenv("TMPDIR", folder.path().c_str(), 1);
            const PendingFile pending(folder.file("x.exr"));
            const TemporaryFile temporary("bytes", "a.exr", "");
            // Tells the test that all is there.
            put(folder.file("ready"), "");
            while (true) {
                ::pause();
            }
        }
        for (int wait = 0; !fs::exists(folder.file("ready")) && wait < 10000; ++wait) {
            ::usleep(1000);
        }
        EXPECT_EQ(folder.count(), 3U);
        ASSERT_EQ(::kill(child, signal), 0);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
        EXPECT_EQ(folder.count(), 1U) << signal;
    }
}

TEST(PendingFile, leaves_ignored_signals_ignored) {
    const ScratchFolder folder;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        ::signal(SIGHUP, SIG_IGN);
        PendingFile pending(folder.file("x"));
        ::raise(SIGHUP);
        pending.commit();
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_TRUE(fs::exists(folder.file("x")));
}

TEST(TemporaryFile, says_what_to_do_where_there_is_no_place_for_it) {
    const char* const before = std::getenv("TMPDIR");
    const std::string kept = before ? before : "";
    ::setenv("TMPDIR", "/nonexistent", 1);
    std::string text;
    try {
        const TemporaryFile file("bytes", "a.exr", "");
    } catch (const Error& e) {
        text = e.what();
    }
    before ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
    EXPECT_NE(text.find("TMPDIR can name a writable place"), std::string::npos) << text;
}

TEST(ExtensionOf, is_lower_case_and_only_of_the_file_name) {
    EXPECT_EQ(extension_of("a.b/LOOK.CUBE"), "cube");
    EXPECT_EQ(extension_of("a.b/look"), "");
}

// The child replaces a large file over and over; it is killed as soon as its temporary file shows.
TEST(WriteFile, killed_in_the_middle_leaves_the_old_or_the_whole_new_file) {
    const ScratchFolder folder;
    const std::string path = folder.file("big");
    constexpr std::size_t size = 4 << 20;
    write_file(path, std::string(size, 'a'));
    int killed_while_writing = 0;
    for (int round = 0; round < 20; ++round) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (char c = 'a';; c = c == 'z' ? 'a' : static_cast<char>(c + 1)) {
                write_file(path, std::string(size, c));
            }
        }
        for (int wait = 0; folder.count() < 2 && wait < 100000; ++wait) {
            ::usleep(100);
        }
        ::usleep(static_cast<useconds_t>(100 * round));
        ASSERT_EQ(::kill(child, SIGKILL), 0);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status));
        const std::string now = read_file(path);
        ASSERT_EQ(now.size(), size);
        ASSERT_EQ(now.find_first_not_of(now[0]), std::string::npos);
        for (const auto& entry : fs::directory_iterator(folder.path())) {
            if (entry.path() != path) {
                ++killed_while_writing;
                fs::remove(entry.path());
            }
        }
    }
    EXPECT_GT(killed_while_writing, 0) << "no kill came during a write; the test proved nothing";
}

} // namespace
} // namespace lutlib::io
