// lutconv as a function: its command line in, its exit code out. Errors are caught here and nowhere
// else.
#pragma once

namespace converter {

/// Parses argv[1] .. argv[argc - 1], runs the verb, prints what went wrong. Returns an ExitCode.
int run_program(int argc, const char* const* argv);

} // namespace converter
