// lutpreview: renders a scene or a picture, finishes it as an engine would and shows two looks.
// Errors are caught here and nowhere else.
#include "lutlib/error.h"
#include "lutlib/io/reason.h"
#include "lutlib/io/terminal.h"
#include "preview/cli/modes.h"
#include "preview/cli/option_papers.h"
#include "preview/cli/versions.h"
#include "terminal/command_line.h"
#include "terminal/complaint.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <string>

namespace preview {
namespace {

enum ExitCode { ok = 0, failed = 1, bad_input = 2, bad_usage = 3 };

constexpr const char* examples = R"(Examples:
lutpreview --b look.json
lutpreview --b strip.png --engine piccolo --headless --size 1280x720 -o split.png
lutpreview photo.exr --a look.cube --b strip.png --engine unreal --compare diff --headless -o x.png
lutpreview night --effect glitch --frames 0-47 --headless -o frame.####.png
lutpreview check model.glb --json
lutpreview report -o report.html --budget-ms 1
)";

/// Throws lutlib::Error.
ExitCode parse_and_run(CLI::App& app, const Options& options, int argc, const char* const* argv) {
    if (terminal::asks_for_papers(argc, argv)) {
        terminal::write_papers(papers(app), argv[2]);
    } else if (const auto asked = terminal::parse(app, argc, argv)) {
        lutlib::io::print_out(*asked);
    } else {
        return run(options) ? ok : failed;
    }
    return ok;
}

} // namespace
} // namespace preview

int main(int argc, char** argv) {
    using terminal::complain, terminal::is_word_of;
    lutlib::io::open_standard_streams();
    CLI::App app(
        "Renders a scene or a picture, finishes it in an engine's order (bloom, tone map, "
        "LUT, antialiasing) and shows two looks side by side.\n"
        "Exit codes: 0 ok, 1 what was checked does not hold, 2 bad input or a machine that cannot "
        "(no display, no Vulkan), 3 bad usage.",
        "lutpreview");
    app.footer(preview::examples);
    app.set_version_flag(
        "--version", [&] { return preview::versions(is_word_of("--verbose", argc, argv)); },
        "Show this program's version and those of what it uses; with --verbose also what holds the "
        "processes that read strangers' files");
    preview::Options options;
    preview::declare(app, options);
    // Beside a picture on standard output there is no room for it.
    const bool in_json = is_word_of("--json", argc, argv) && !is_word_of("-", argc, argv);
    try {
        return preview::parse_and_run(app, options, argc, argv);
    } catch (const lutlib::UsageError& error) {
        return complain("lutpreview", error, preview::bad_usage, in_json);
    } catch (const lutlib::Error& error) {
        return complain("lutpreview", error, preview::bad_input, in_json);
    } catch (const std::exception& error) {
        return complain("lutpreview", lutlib::Error(lutlib::io::reason_of(error)),
                        preview::bad_input, in_json);
    }
}
