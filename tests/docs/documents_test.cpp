// Every command line of README.md and docs/*.md does what its document says.
#include "tests/docs/command_lines.h"
#include "tests/docs/workplace.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

namespace docs_test {
namespace {

namespace fs = std::filesystem;

/// Lines that are not run, by what they begin with, and why.
struct Exception {
    std::string_view begins, reason;
};
constexpr Exception exceptions[] = {
    {"scripts/", "builds everything, this test too"},
    {"cmake ", "builds everything, this test too"},
    {"ctest ", "runs this test"},
    {"export ", "sets up the reader's shell"},
    {"xvfb-run ", "wants a screen and ffmpeg"},
    {"ffmpeg ", "wants ffmpeg and a film"},
    {"lutpreview --b look.json ", "opens a window"},
    {"lutpreview report -o report.html ", "takes minutes on a software device"},
    {"lutconv bake look.json -o strip.png --watch ", "goes on until somebody ends it"},
    {"lutconv bake look.json -o Assets/Luts/look.png ", "goes on until somebody ends it"},
    {"build/bin/preview_golden_tests", "renews golden pictures"},
};

/// Lines that take minutes on slow machines, and whose work other tests check on less: run by
/// `scripts/test --all`.
constexpr std::string_view long_lines[] = {
    "lutconv report --suite stiff",
    "lutpreview report -o report.html --json --csv",
};

/// Lines whose exit code is not 0, or whose output must hold what the text around them promises.
struct Promise {
    std::string_view holds; ///< what the line contains
    int exit_code = 0;
    std::string_view says{};
};
constexpr Promise promises[] = {
    {"verify strip.png --against \"My Look.cube\" --engine unreal", 0, "passed as Unreal Engine"},
    {"verify strip.png --against look.json", 0, "passed as"},
    {"-o look.spi3d --strict", 2, "--strict: not written"},
    {"--look-input logc3 --look-output srgb", 0, "srgb is converted to logc3 before the look"},
    {"--picture-encoding linear", 0, "linear is converted to srgb before the look"},
    {"--original shot.png", 0, "dE2000 mean"},
    {"--repair", 0, "repair"},
    {"--max-delta-e 1", 0, "stays within dE2000 1"},
    {"--measure", 0, "dE2000: p99"},
    {"--compare diff", 0, "dE2000"},
    {"--probe", 0, "dE2000"},
    {"--explain -o x.png", 0, "shadow"},
    {"--timings", 0, "ms"},
    {"--list", 0, "piccolo"},
    {"-o graded/{name}.{ext}", 0, "3 pictures -> graded/"},
    {"--shard 1/2", 0, "2 pictures -> graded/"},
    {"lutconv sheet", 0, "dE2000 of the picture's pixels from the original"},
    {"lutconv match before.png", 0, "held out"},
    {"--chart-before", 0, "dE2000 of the look at them"},
    {"lutconv info", 0, "nodes per axis"},
    {"lutconv eval look.cube 0.18 0.18 0.18", 0, "0.2081"},
};

std::string contents(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Sizes such as 256x16 in a comment: the output must tell them.
std::vector<std::string> sizes_in(const std::string& comment) {
    static const std::regex size("[0-9]+x[0-9]+");
    std::vector<std::string> out;
    for (std::sregex_iterator at(comment.begin(), comment.end(), size), end; at != end; ++at) {
        out.push_back(at->str());
    }
    return out;
}

/// A folder that is removed with the object.
class Scratch {
  public:
    Scratch() {
        std::string pattern = (fs::temp_directory_path() / "docs-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~Scratch() { fs::remove_all(path_); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    fs::path operator/(const char* name) const { return path_ / name; }

  private:
    fs::path path_;
};

bool is_excepted(const CommandLine& command) {
    // A line alone ends where the exception's own blank stands.
    return std::any_of(std::begin(exceptions), std::end(exceptions), [&](const Exception& e) {
        return (command.text + ' ').starts_with(e.begins);
    });
}

bool is_left_to_all(const CommandLine& command) {
    return !support::is_thorough() &&
           std::any_of(std::begin(long_lines), std::end(long_lines),
                       [&](std::string_view begins) { return command.text.starts_with(begins); });
}

bool needs_a_program_that_is_not_built(const CommandLine& command) {
    return command.text.starts_with("lutpreview") && !fs::exists(fs::path(PROGRAMS) / "lutpreview");
}

void expect_kept(const CommandLine& command, const Ran& ran) {
    int exit_code = 0;
    for (const Promise& promise : promises) {
        if (command.text.find(promise.holds) != std::string::npos) {
            exit_code = promise.exit_code;
            EXPECT_NE(ran.output.find(promise.says), std::string::npos)
                << "does not say '" << promise.says << "'";
        }
    }
    EXPECT_EQ(ran.exit_code, exit_code);
    for (const std::string& size : sizes_in(command.comment())) {
        EXPECT_NE(ran.output.find(size), std::string::npos) << "does not say " << size;
    }
}

/// Each line in a fresh copy of the workplace, for documents use names again.
std::size_t run_all(const fs::path& document) {
    const Scratch scratch;
    const fs::path made = scratch / "made", used = scratch / "used";
    fs::create_directory(made);
    fill_workplace(made);
    std::size_t count = 0;
    for (const CommandLine& command : command_lines(contents(document))) {
        if (is_excepted(command) || is_left_to_all(command) ||
            needs_a_program_that_is_not_built(command)) {
            continue;
        }
        fs::copy(made, used, fs::copy_options::recursive);
        const Ran ran = run_in(used, command.text);
        SCOPED_TRACE(document.filename().string() + ':' + std::to_string(command.line) + ": " +
                     command.text + '\n' + ran.output);
        expect_kept(command, ran);
        fs::remove_all(used);
        ++count;
    }
    return count;
}

TEST(CommandLines, are_the_indented_blocks_with_what_goes_on_over_lines) {
    const auto lines =
        command_lines("Text\n    no block, but text\n\n    a 'b # c' # d\n"
                      "    e \\\n        f\n\n- list\n\n    sh -c '\n        g\n    '\n");
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].text, "a 'b # c' # d");
    EXPECT_EQ(lines[0].line, 4U);
    EXPECT_EQ(lines[0].comment(), " d");
    EXPECT_EQ(lines[1].text, "e \\\n    f");
    EXPECT_EQ(lines[2].text, "sh -c '\n    g\n'");
}

TEST(Documents, readme_runs_as_it_stands) {
    EXPECT_GT(run_all(fs::path(REPOSITORY) / "README.md"), 20U);
}

TEST(Documents, in_docs_run_as_they_stand) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(REPOSITORY) / "docs")) {
        if (entry.path().extension() == ".md") {
            run_all(entry.path());
        }
    }
}

// An exception or a promise of a line that no document has is a mistake in it.
TEST(Documents, have_every_line_that_is_excepted_or_promised) {
    std::string all = contents(fs::path(REPOSITORY) / "README.md") +
                      contents(fs::path(REPOSITORY) / "CONTRIBUTING.md");
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(REPOSITORY) / "docs")) {
        all += entry.path().extension() == ".md" ? contents(entry.path()) : "";
    }
    for (const Promise& promise : promises) {
        EXPECT_NE(all.find(promise.holds), std::string::npos) << promise.holds;
    }
}

} // namespace
} // namespace docs_test
