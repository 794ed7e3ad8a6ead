// Where the window keeps what it remembers.
#pragma once

#include <filesystem>

namespace preview::editor {

/// A folder of the user's configuration by the XDG Base Directory Specification, which does not
/// count what is empty or relative. It is made. Empty when there can be none.
std::filesystem::path settings_folder();

} // namespace preview::editor
