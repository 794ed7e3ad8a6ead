// --quiet: nothing but errors and JSON is printed.
#pragma once

namespace converter {

void set_quiet(bool quiet);
bool is_quiet();

} // namespace converter
