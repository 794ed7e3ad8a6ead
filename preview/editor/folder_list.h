// What a folder has for a person to choose from. Plain: no drawing.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace preview::editor {

/// Which files a list shows.
struct FileKind {
    std::string_view label;
    std::vector<std::string> extensions; ///< lower case, without the dot; none: every file
};
/// The first is what the window opens at all, the last every file. Looks follow
/// lutlib::io::file_formats().
std::span<const FileKind> file_kinds();

struct FolderEntry {
    std::string name; ///< within the folder
    bool is_folder = false;
    friend bool operator==(const FolderEntry&, const FolderEntry&) = default;
};

struct FolderList {
    std::vector<FolderEntry> entries; ///< folders first, both by name, upper and lower case alike
    std::string reason;               ///< why there is none; empty when there is
};

/// Of the kind's files and all folders; what begins with a dot is left out.
FolderList list_folder(const std::string& folder, const FileKind& kind);

/// What `typed` names in `folder`: an absolute path, one of the home folder's (~/), or one of
/// `folder`; normal, without a slash at its end.
std::string path_in(const std::string& folder, const std::string& typed);

/// The files opened or saved last, the newest first.
inline constexpr std::size_t most_recent_files = 12;
/// Puts `path`, made absolute, before them.
void remember_file(std::vector<std::string>& recent, const std::string& path);

} // namespace preview::editor
