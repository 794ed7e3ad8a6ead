#include "preview/editor/settings_folder.h"

#include <cstdlib>
#include <system_error>

namespace preview::editor {

namespace fs = std::filesystem;

fs::path settings_folder() {
    const auto folder_in = [](const char* variable) {
        const char* const value = std::getenv(variable);
        const fs::path path = value != nullptr ? value : "";
        return path.is_absolute() ? path : fs::path();
    };
    fs::path folder = folder_in("XDG_CONFIG_HOME");
    if (folder.empty()) {
        if (folder = folder_in("HOME"); folder.empty()) {
            return {};
        }
        folder /= ".config";
    }
    folder /= "lutpreview";
    std::error_code failed;
    fs::create_directories(folder, failed);
    return failed ? fs::path() : folder;
}

} // namespace preview::editor
