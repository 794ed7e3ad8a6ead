// What people are told of an exception.
#pragma once

#include <exception>
#include <string>

namespace lutlib::io {

/// The name of what this thread opened last to read (FileInput); empty: nothing.
const std::string& last_input();

/// Of an Error its own words. Of memory that could not be had, the file that this thread opened
/// last and that; of others what they say.
std::string reason_of(const std::exception& error);

} // namespace lutlib::io
