#include "converter/program.h"

#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/reading_limits.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/named.h"
#include "lutlib/version.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <exception>
#include <sstream>

namespace converter {
namespace {

// The words of a command line that did not parse, or of the help that it asked for.
int answer(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = app.exit(error, out, err);
    print(out.str(), "");
    print(err.str(), std::string(lutlib::io::standard_stream));
    return code == 0 ? ok : bad_usage;
}

// CLI11 would only say that a verb is missing.
void require_verb(int argc, const char* const* argv) {
    const std::string_view word = argc > 1 ? argv[1] : "-";
    if (!word.starts_with('-')) {
        lutlib::require_named(commands(), "verb", word);
    }
}

bool is_word_of(std::string_view word, int argc, const char* const* argv) {
    return std::find(argv, argv + argc, word) != argv + argc;
}

// Returns an ExitCode. Throws lutlib::Error.
int parse_and_run(CLI::App& app, const Run& run, int argc, const char* const* argv) {
    require_verb(argc, argv);
    if (is_word_of("--version", argc, argv) && is_word_of("--verbose", argc, argv)) {
        print(verbose_version() + "\n", "");
        return ok;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return answer(app, error);
    }
    apply_reading_limits();
    const int code = run();
    tell_unused_layout();
    return code;
}

int complain(const char* message, int code) {
    std::fprintf(stderr, "lutconv: %s\n", one_line(message).c_str());
    return code;
}

} // namespace

int run_program(int argc, const char* const* argv) {
    CLI::App app("Bakes, verifies, converts and edits colour LUTs.\n"
                 "Exit codes: 0 ok, 1 verification failed, 2 bad input, 3 bad usage.",
                 "lutconv");
    app.require_subcommand(1);
    app.set_version_flag("--version", std::string(lutlib::version));
    Run run;
    std::deque<Verb> verbs;
    for (const Command& command : commands()) {
        CLI::App* const verb =
            app.add_subcommand(std::string(command.name), std::string(command.help));
        if (!is_word_of(command.name, argc, argv)) {
            continue; // some two hundred options cost a third of a small bake
        }
        Verb& declared = verbs.emplace_back(*verb);
        verb->final_callback([&run, chosen = command.declare(declared)] { run = chosen; });
        if (command.reads_looks) {
            declare_layout(declared);
            declare_reading_limits(declared);
        }
    }
    try {
        return parse_and_run(app, run, argc, argv);
    } catch (const lutlib::UsageError& error) {
        return complain(error.what(), bad_usage);
    } catch (const lutlib::Error& error) {
        return complain(error.what(), bad_input);
    } catch (const std::bad_alloc&) {
        return complain("not enough memory for this input", bad_input);
    } catch (const std::exception& error) {
        return complain(error.what(), bad_input);
    }
}

} // namespace converter
