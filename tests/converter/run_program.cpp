#include "tests/converter/run_program.h"

#include "converter/program.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>

extern char** environ;

namespace converter_test {
namespace {

// Sends a file descriptor to a file for as long as it lives.
class Redirection {
  public:
    Redirection(int descriptor, const std::string& path)
        : descriptor_(descriptor), before_(dup(descriptor)) {
        const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(file, descriptor);
        close(file);
    }
    ~Redirection() {
        dup2(before_, descriptor_);
        close(before_);
    }
    Redirection(const Redirection&) = delete;
    Redirection& operator=(const Redirection&) = delete;

  private:
    int descriptor_, before_;
};

void flush_all() {
    std::cout.flush();
    std::fflush(nullptr);
}

} // namespace

Result lutconv(const std::vector<std::string>& arguments, const std::string& input) {
    // A sanitizer sees the same in this process, and its start costs a third of a second.
    return support::is_sanitized && input.empty() ? lutconv_in_process(arguments)
                                                  : lutconv_process(arguments, input);
}

Result lutconv_process(const std::vector<std::string>& arguments, const std::string& input) {
    const Folder folder;
    const std::string in = folder.write("in", input), out = folder.path("out"),
                      err = folder.path("err");
    std::vector<std::string> words{LUTCONV};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, in.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&files, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    pid_t child = 0;
    const int failed = posix_spawn(&child, LUTCONV, &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    EXPECT_EQ(failed, 0);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status)) << "lutconv was killed by signal " << WTERMSIG(status);
    return {WEXITSTATUS(status), contents(out), contents(err)};
}

Result lutconv_in_process(const std::vector<std::string>& arguments) {
    const Folder folder;
    const std::string out = folder.path("out"), err = folder.path("err");
    std::vector<const char*> argv{"lutconv"};
    for (const std::string& word : arguments) {
        argv.push_back(word.c_str());
    }
    Result result;
    flush_all();
    {
        const Redirection to_out(1, out), to_err(2, err);
        result.exit_code = converter::run_program(static_cast<int>(argv.size()), argv.data());
        flush_all();
    }
    result.out = contents(out);
    result.err = contents(err);
    return result;
}

std::vector<std::string> verbs() {
    std::vector<std::string> out;
    const std::string help = lutconv({"--help"}).out;
    std::size_t at = help.find("Subcommands:");
    while ((at = help.find("\n  ", at)) != std::string::npos) {
        at += 3;
        if (help[at] != ' ') {
            out.push_back(help.substr(at, help.find(' ', at) - at));
        }
    }
    return out;
}

Folder::Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "lutconv-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
}

Folder::~Folder() {
    std::filesystem::remove_all(path_);
}

std::string Folder::write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path(name);
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        out.push_back(entry.path().filename().string());
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string saturated_cube(int size, const std::string& head) {
    std::string out = head + "LUT_3D_SIZE " + std::to_string(size) + "\n";
    std::array<char, 64> row{};
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                const double n = size - 1;
                const double y = (0.2126 * r + 0.7152 * g + 0.0722 * b) / n;
                const auto saturate = [&](int v) {
                    return std::clamp(y + 1.6 * (v / n - y), 0.0, 1.0);
                };
                const int length = std::snprintf(row.data(), row.size(), "%.6f %.6f %.6f\n",
                                                 saturate(r), saturate(g), saturate(b));
                out.append(row.data(), static_cast<std::size_t>(length));
            }
        }
    }
    return out;
}

} // namespace converter_test
