// The standard streams of a program, and text from files on its way to them.
#pragma once

#include <string>
#include <string_view>

namespace lutlib::io {

/// Text as people may see it: control characters (C0, C1), those that turn the direction of writing
/// or end lines unseen, and bytes that are no UTF-8 are spelled out: "\x1b", "\n", "\u202e". `kept`
/// stays as it is, such as '\n' of a text of several lines.
std::string shown_text(std::string_view text, char kept = ' ');

/// Whether all of it is UTF-8.
bool is_utf8(std::string_view text);

/// To be called before anything else: a file that is opened while one of the standard streams is
/// closed would get that stream's number, and what is printed would go into it.
void open_standard_streams();
/// Whether open_standard_streams() found it so: whatever is printed is lost, which is its user's
/// will, but a file that is to go there is not.
bool standard_output_was_closed();

/// The text, shown, on standard output. Throws Error when it cannot be written.
void print_out(std::string_view text);
/// The same of text that is shown already, with a terminal's colours in it.
void print_marked(const std::string& shown);
/// print_out() on standard error, where a failure has nobody to be told to.
void print_err(std::string_view text);

} // namespace lutlib::io
