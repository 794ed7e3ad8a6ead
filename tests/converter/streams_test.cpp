// What a shell can do to the standard streams of a program, and which of its outputs goes where.
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sys/wait.h>

namespace converter_test {
namespace {

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
        EXPECT_EQ(in_shell("bake '" + look + "' -o '" + closed + "'", streams), 0) << streams;
        EXPECT_TRUE(contents(closed) == contents(open)) << streams;
    }
}

} // namespace
} // namespace converter_test
