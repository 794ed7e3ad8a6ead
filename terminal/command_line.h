// Reads a command line, and says what is wrong with it in words for whoever typed it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace terminal {

/// Whether a word stands there, wherever; for what must be known before the options are.
bool is_word_of(std::string_view word, int argc, const char* const* argv);

/// Reads the words into what `app` declares. Returns the text to print where they ask for help or
/// the version, else nothing. Throws lutlib::UsageError for the mistake that was typed first, with
/// the option that may have been meant.
std::optional<std::string> parse(CLI::App& app, int argc, const char* const* argv);

} // namespace terminal
