// Whether strangers' files are read by OpenImageIO and OpenColorIO in processes of their own,
// within limits (confine.h).
#pragma once

namespace lutlib::io::box {

/// At first they are.
bool is_used();
/// For the whole program; to be said before the first file is read.
void set_used(bool is_used);

} // namespace lutlib::io::box
