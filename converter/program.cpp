#include "converter/program.h"

#include "converter/command.h"
#include "converter/command_papers.h"
#include "converter/examples.h"
#include "converter/look_files.h"
#include "converter/quiet.h"
#include "converter/reading_limits.h"
#include "converter/replaceable.h"
#include "converter/report.h"
#include "lutlib/error.h"
#include "lutlib/io/reason.h"
#include "lutlib/named.h"
#include "lutlib/version.h"
#include "terminal/command_line.h"
#include "terminal/complaint.h"
#include "terminal/papers.h"
#include "terminal/versions.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <deque>
#include <exception>
#include <vector>

namespace converter {
namespace {

using terminal::complain;
using terminal::is_word_of;

// Whether whoever reads standard output expects JSON of it, and nothing else. After report's --json
// stands a file.
bool answers_in_json(int argc, const char* const* argv) {
    return argc > 1 && std::string_view(argv[1]) != "report" && is_word_of("--json", argc, argv) &&
           !is_word_of("-", argc, argv);
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
    if (const auto asked = terminal::parse(app, argc, argv)) {
        print(*asked, "");
        return ok;
    }
    apply_reading_limits();
    const int code = run();
    tell_unused_layout();
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

/// What every verb takes alike.
struct Manners {
    bool quiet = false, force = false;
};

void declare(const Command& command, CLI::App& app, Verb& verb, Run& run, Manners& manners) {
    app.final_callback([&run, &verb, chosen = command.declare(verb)] {
        run = [&verb, chosen] {
            require_replaceable(verb);
            return chosen();
        };
    });
    if (verb.writes()) {
        declare_force(verb, manners.force);
    }
    if (command.reads_looks) {
        declare_layout(verb);
        declare_reading_limits(verb);
    }
    if (!command.is_answer) {
        verb.add_flag("--quiet", manners.quiet,
                      "print no report; warnings and errors are still said");
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
    const bool writes_papers = terminal::asks_for_papers(argc, argv);
    CLI::App app("Bakes, verifies, converts and edits colour LUTs.\n"
                 "Exit codes: 0 ok, 1 verification failed, 2 bad input, 3 bad usage.",
                 "lutconv");
    app.require_subcommand(1);
    app.set_version_flag(
        "--version",
        [&] {
            return fmt::format("lutconv {}\n{}{}", lutlib::version, terminal::loaded_versions(),
                               is_word_of("--verbose", argc, argv) ? terminal::holding_line() : "");
        },
        "show this program's version and those of what it loads on demand; with --verbose also "
        "what "
        "holds the processes that read strangers' files");
    Run run;
    Manners manners;
    std::deque<Verb> verbs;
    for (const Command& command : commands()) {
        CLI::App* const verb =
            app.add_subcommand(std::string(command.name), std::string(command.help));
        if (writes_papers || is_word_of(command.name, argc, argv)) {
            declare(command, *verb, verbs.emplace_back(*verb), run, manners);
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
                set_quiet(manners.quiet);
                set_force(manners.force);
                return run();
            },
            argc, argv);
    } catch (const lutlib::UsageError& error) {
        return complain("lutconv", error, bad_usage, in_json);
    } catch (const lutlib::Error& error) {
        return complain("lutconv", error, bad_input, in_json);
    } catch (const std::exception& error) {
        return complain("lutconv", lutlib::Error(lutlib::io::reason_of(error)), bad_input, in_json);
    }
}

} // namespace converter
