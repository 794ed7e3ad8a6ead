// Whether strangers' files are read by OpenImageIO and OpenColorIO in processes of their own,
// within limits (confine.h).
#pragma once

#include <cstddef>
#include <string>

namespace lutlib::io::box {

/// At first they are.
bool is_used();
/// For the whole program; to be said before the first file is read.
void set_used(bool is_used);

/// The address space, in bytes, of each such process that is made from now on; at first 4 GiB.
void set_memory(std::size_t bytes);
std::size_t memory();

/// What holds such a process on this system, a line. Throws Error when none can be started.
std::string holding_text();

} // namespace lutlib::io::box
