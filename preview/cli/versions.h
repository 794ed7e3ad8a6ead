// What lutpreview --version prints.
#pragma once

#include <string>

namespace preview {

/// The program's version and those of what it uses, a line each; `verbose` adds what holds the
/// processes that read strangers' files.
std::string versions(bool verbose);

} // namespace preview
