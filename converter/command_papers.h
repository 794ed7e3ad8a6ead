// lutconv's man pages and completions.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace converter {

/// Of a program whose verbs are all declared, into a prefix's share/. Throws lutlib::Error.
void write_command_papers(const CLI::App& app, const std::string& folder);

} // namespace converter
