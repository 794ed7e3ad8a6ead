// lutpreview: renders a scene or a picture, finishes it as an engine would and shows two looks.
// Errors are caught here and nowhere else.
#include "lutlib/error.h"
#include "lutlib/io/reason.h"
#include "lutlib/io/terminal.h"
#include "lutlib/version.h"
#include "preview/cli/modes.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <sstream>
#include <string>

namespace preview {
namespace {

enum ExitCode { ok = 0, bad_input = 2, bad_usage = 3 };

int complain(const char* message, int code) {
    lutlib::io::print_err("lutpreview: " + lutlib::io::shown_text(message) + "\n");
    return code;
}

/// The words of a command line that did not parse, or of the help that it asked for.
int answer(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = app.exit(error, out, err);
    try {
        lutlib::io::print_out(out.str());
    } catch (const lutlib::Error& failed) {
        return complain(failed.what(), bad_input);
    }
    lutlib::io::print_err(err.str());
    return code == 0 ? ok : bad_usage;
}

} // namespace
} // namespace preview

int main(int argc, char** argv) {
    lutlib::io::open_standard_streams();
    CLI::App app(
        "Renders a scene or a picture, finishes it in an engine's order (bloom, tone map, "
        "LUT, antialiasing) and shows two looks side by side.\n"
        "Exit codes: 0 ok, 2 bad input or a machine that cannot (no display, no Vulkan), 3 "
        "bad usage.",
        "lutpreview");
    app.set_version_flag("--version", std::string(lutlib::version));
    preview::Options options;
    preview::declare(app, options);
    try {
        app.parse(argc, argv);
        preview::run(options);
        return preview::ok;
    } catch (const CLI::ParseError& error) {
        return preview::answer(app, error);
    } catch (const lutlib::UsageError& error) {
        return preview::complain(error.what(), preview::bad_usage);
    } catch (const std::exception& error) {
        return preview::complain(lutlib::io::reason_of(error).c_str(), preview::bad_input);
    }
}
