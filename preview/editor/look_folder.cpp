#include "preview/editor/look_folder.h"

#include "lutlib/io/extension.h"
#include "preview/editor/folder_list.h"

#include <algorithm>
#include <filesystem>

namespace preview::editor {

std::string file_of_look(const State& state) {
    const std::string& path = !state.recipe_path.empty() ? state.recipe_path : state.base_path;
    std::error_code unknown;
    if (path.empty() || (!std::filesystem::is_regular_file(path, unknown) && !may_be_look(path))) {
        return {}; // standard input; a file that is gone had its folder
    }
    return path_in(std::filesystem::current_path(unknown).string(), path);
}

namespace {

const FileKind& kind_of_looks() {
    const auto kinds = file_kinds();
    return *std::find_if(kinds.begin(), kinds.end(),
                         [](const FileKind& kind) { return kind.label == "looks"; });
}

} // namespace

bool may_be_look(const std::string& path) {
    const auto& endings = kind_of_looks().extensions;
    return std::find(endings.begin(), endings.end(), lutlib::io::extension_of(path)) !=
           endings.end();
}

LookFolder looks_in(const std::string& folder) {
    const FolderList list = list_folder(folder, kind_of_looks());
    LookFolder out{folder, {}, list.reason};
    for (const FolderEntry& entry : list.entries) {
        if (!entry.is_folder) {
            out.names.push_back(entry.name);
        }
    }
    return out;
}

std::optional<std::size_t> place_of(const LookFolder& folder, const std::string& path) {
    const std::filesystem::path file(path);
    if (file.parent_path() != folder.folder) {
        return std::nullopt;
    }
    const auto found =
        std::find(folder.names.begin(), folder.names.end(), file.filename().string());
    if (found == folder.names.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - folder.names.begin());
}

std::size_t place_beside(std::optional<std::size_t> at, int step, std::size_t count) {
    if (!at) {
        return step > 0 ? 0 : count - 1;
    }
    return step > 0 ? (*at + 1) % count : (*at + count - 1) % count;
}

} // namespace preview::editor
