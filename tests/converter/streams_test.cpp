// What a shell can do to the standard streams of a program, and which of its outputs goes where.
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <sys/wait.h>

namespace converter_test {
namespace {

using nlohmann::json;

std::string quoted(const std::string& path) {
    std::string out(1, '\'');
    out += path;
    out += '\'';
    return out;
}

// Runs lutconv in a shell and gives the exit code. `redirections` follow its arguments.
int in_shell(const std::string& arguments, const std::string& redirections) {
    const int status = std::system(("'" LUTCONV "' " + arguments + " " + redirections).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Streams, that_are_closed_do_not_end_in_the_files_that_are_written) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5));
    const std::string open = folder.path("open.png"), closed = folder.path("closed.png");
    ASSERT_EQ(lutconv({"bake", look, "-o", open}).exit_code, 0);
    for (const char* streams :
         {"<&- >&-", "<&- >&- 2>&-", ">&- 2>/dev/null", "<&- 2>&- >/dev/null"}) {
        EXPECT_EQ(in_shell("bake " + quoted(look) + " -o " + quoted(closed), streams), 0)
            << streams;
        EXPECT_TRUE(contents(closed) == contents(open)) << streams;
    }
}

TEST(Streams, that_are_closed_take_no_file) {
    const Folder folder;
    const std::string look = quoted(folder.write("a.cube", saturated_cube(5)));
    const std::string err = folder.path("err");
    for (const std::string verb : {"bake", "convert"}) {
        EXPECT_EQ(in_shell(verb + " " + look + " -o -", ">&- 2>" + quoted(err)), 2);
        EXPECT_NE(contents(err).find("standard output is closed"), std::string::npos);
    }
}

TEST(Streams, that_are_full_are_an_error_and_not_silence) {
    const Folder folder;
    const std::string look = quoted(folder.write("a.cube", saturated_cube(5)));
    const std::string err = folder.path("err"), to_err = "2>" + quoted(err);
    for (const std::string& arguments :
         {"info " + look, "info --json " + look, "eval " + look + " 1 1 1", "check " + look,
          "compare " + look + " identity", std::string("--help"), std::string("bake --help"),
          "convert " + look + " -o -"}) {
        EXPECT_EQ(in_shell(arguments, ">/dev/full " + to_err), 2) << arguments;
        EXPECT_NE(contents(err).find("standard output: "), std::string::npos) << contents(err);
        EXPECT_NE(contents(err).find("No space left on device"), std::string::npos);
    }
    EXPECT_EQ(in_shell("--help " + to_err, "| head -1 >/dev/null"), 0);
    EXPECT_EQ(contents(err), "");
}

TEST(Streams, that_carry_an_output_carry_nothing_else) {
    const Folder folder;
    const std::string look = folder.write("a.cube", saturated_cube(5)),
                      page = folder.path("r.html");
    const auto json_of = [](const std::vector<std::string>& arguments) {
        const Result result = lutconv(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(result.err, "") << "where is the report?";
        EXPECT_TRUE(json::accept(result.out)) << result.out;
    };
    json_of({"report", look, "--sizes", "2", "-o", page, "--json", "-"});
    json_of({"edit", look, "-o", folder.path("x.cube"), "--save-recipe", "-"});
    json_of({"edit", look, "-o", folder.path("x.cube"), "--save-recipe", "-", "--json"});
    const Result csv = lutconv({"report", look, "--sizes", "2", "-o", page, "--csv", "-"});
    EXPECT_EQ(csv.out.find("combinations"), std::string::npos) << csv.out;
    EXPECT_NE(csv.err.find("combinations"), std::string::npos) << csv.err;
    EXPECT_EQ(lutconv({"report", look, "-o", "-", "--json", "-"}).exit_code, 3);
    EXPECT_EQ(lutconv({"report", look, "-o", page, "--csv", "-", "--json", "-"}).exit_code, 3);
    EXPECT_EQ(lutconv({"edit", look, "-o", "-", "--save-recipe", "-"}).exit_code, 3);
}

} // namespace
} // namespace converter_test
