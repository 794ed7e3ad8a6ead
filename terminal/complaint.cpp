#include "terminal/complaint.h"

#include "lutlib/io/terminal.h"
#include "terminal/style.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

namespace terminal {
namespace {

std::string as_json(const lutlib::Error& error, int exit_code) {
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
    json["exit_code"] = exit_code;
    return nlohmann::ordered_json{{"error", json}}.dump(
               2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) +
           "\n";
}

} // namespace

int complain(std::string_view program, const lutlib::Error& error, int exit_code, bool in_json) {
    const Style style = style_of(STDERR_FILENO);
    const std::string text =
        style.bad(std::string(program) + ":") + " " + lutlib::io::shown_text(error.what()) + "\n";
    std::fputs(text.c_str(), stderr);
    if (in_json) {
        try {
            lutlib::io::print_out(as_json(error, exit_code));
        } catch (const lutlib::Error&) {
            // Standard output takes nothing, which may be the error itself; standard error has it.
        }
    }
    return exit_code;
}

} // namespace terminal
