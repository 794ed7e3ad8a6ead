#include "converter/program.h"

#include "converter/command.h"
#include "converter/command_papers.h"
#include "converter/examples.h"
#include "converter/look_files.h"
#include "converter/quiet.h"
#include "converter/reading_limits.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/reason.h"
#include "lutlib/named.h"
#include "lutlib/version.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <exception>
#include <sstream>
#include <vector>

namespace converter {
namespace {

bool is_word_of(std::string_view word, int argc, const char* const* argv) {
    return std::find(argv, argv + argc, word) != argv + argc;
}

// Whether whoever reads standard output expects JSON of it, and nothing else. After report's --json
// stands a file.
bool answers_in_json(int argc, const char* const* argv) {
    return argc > 1 && std::string_view(argv[1]) != "report" && is_word_of("--json", argc, argv) &&
           !is_word_of("-", argc, argv);
}

void print_error_json(const lutlib::Error& error, int code) {
    const lutlib::Where& where = error.where();
    nlohmann::ordered_json json{{"message", error.message()}};
    json["file"] = nullptr;
    json["line"] = nullptr;
    if (!where.file.empty()) {
        json["file"] = where.file;
    }
    if (where.line > 0) {
        json["line"] = where.line;
    }
    json["exit_code"] = code;
    try {
        print(nlohmann::ordered_json{{"error", json}}, "");
    } catch (const lutlib::Error&) {
        // Standard output takes nothing, which may be the error itself; standard error has it.
    }
}

// The words of a command line that did not parse, or of the help that it asked for.
int answer(const CLI::App& app, const CLI::ParseError& error, bool in_json) {
    std::ostringstream out, err;
    if (app.exit(error, out, err) == 0) {
        print(out.str(), "");
        return ok;
    }
    print("lutconv: " + err.str(), std::string(lutlib::io::standard_stream));
    if (in_json) {
        print_error_json(lutlib::UsageError(error.what()), bad_usage);
    }
    return bad_usage;
}

// CLI11 would only say that a verb is missing.
void require_verb(int argc, const char* const* argv) {
    const std::string_view word = argc > 1 ? argv[1] : "-";
    if (!word.starts_with('-')) {
        lutlib::require_named(commands(), "verb", word);
    }
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
        return answer(app, error, answers_in_json(argc, argv));
    }
    apply_reading_limits();
    const int code = run();
    tell_unused_layout();
    return code;
}

int complain(const lutlib::Error& error, int code, bool in_json) {
    std::fprintf(stderr, "lutconv: %s\n", one_line(error.what()).c_str());
    if (in_json) {
        print_error_json(error, code);
    }
    return code;
}

// "help VERB" is "VERB --help".
std::vector<const char*> spelled_out(int argc, const char* const* argv) {
    std::vector<const char*> out(argv, argv + argc);
    if (argc > 1 && std::string_view(argv[1]) == "help") {
        out.erase(out.begin() + 1);
        out.push_back("--help");
    }
    return out;
}

void declare(const Command& command, CLI::App& app, Verb& verb, Run& run, bool& quiet) {
    app.final_callback([&run, chosen = command.declare(verb)] { run = chosen; });
    if (command.reads_looks) {
        declare_layout(verb);
        declare_reading_limits(verb);
    }
    if (!command.is_answer) {
        verb.add_flag("--quiet", quiet, "print no report; warnings and errors are still said");
    }
    const std::string notes = app.get_footer();
    app.footer((notes.empty() ? "" : notes + "\n\n") + "Examples:\n" +
               std::string(examples_of(command.name)));
}

} // namespace

int run_program(int given, const char* const* words) {
    const std::vector<const char*> all = spelled_out(given, words);
    const int argc = static_cast<int>(all.size());
    const char* const* const argv = all.data();
    const bool in_json = answers_in_json(argc, argv);
    // For the build: what is installed beside the program.
    const bool writes_papers = argc == 3 && std::string_view(argv[1]) == "--write-papers";
    CLI::App app("Bakes, verifies, converts and edits colour LUTs.\n"
                 "Exit codes: 0 ok, 1 verification failed, 2 bad input, 3 bad usage.",
                 "lutconv");
    app.require_subcommand(1);
    app.set_version_flag("--version", std::string(lutlib::version));
    Run run;
    bool quiet = false;
    std::deque<Verb> verbs;
    for (const Command& command : commands()) {
        CLI::App* const verb =
            app.add_subcommand(std::string(command.name), std::string(command.help));
        if (writes_papers || is_word_of(command.name, argc, argv)) {
            declare(command, *verb, verbs.emplace_back(*verb), run, quiet);
        } // else not: some two hundred options cost a third of a small bake
    }
    app.footer("'lutconv help VERB' shows a verb's options and examples of it.");
    try {
        if (writes_papers) {
            write_command_papers(app, argv[2]);
            return ok;
        }
        set_quiet(false);
        return parse_and_run(
            app,
            [&] {
                set_quiet(quiet);
                return run();
            },
            argc, argv);
    } catch (const lutlib::UsageError& error) {
        return complain(error, bad_usage, in_json);
    } catch (const lutlib::Error& error) {
        return complain(error, bad_input, in_json);
    } catch (const std::exception& error) {
        return complain(lutlib::Error(lutlib::io::reason_of(error)), bad_input, in_json);
    }
}

} // namespace converter
