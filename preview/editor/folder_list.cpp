#include "preview/editor/folder_list.h"

#include "lutlib/io/extension.h"
#include "lutlib/io/formats.h"
#include "lutlib/recipe/correction_file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace preview::editor {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

Words look_extensions() {
    Words out{"json"};
    for (const lutlib::FileFormat* const format : lutlib::io::file_formats()) {
        out.insert(out.end(), format->extensions.begin(), format->extensions.end());
    }
    return out;
}

Words joined(Words first, const Words& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

std::vector<FileKind> kinds() {
    const Words looks = look_extensions(), models{"gltf", "glb", "obj"},
                pictures{"png", "exr",  "hdr", "jpg", "jpeg", "tif", "tiff",
                         "tga", "webp", "dpx", "bmp", "ppm",  "psd", "cin"};
    Words corrections;
    for (const lutlib::CorrectionFormat& format : lutlib::correction_formats()) {
        corrections.emplace_back(format.extension);
    }
    return {{"looks, pictures, models", joined(joined(looks, pictures), models)},
            {"looks", looks},
            {"pictures", pictures},
            {"models", models},
            {"ASC CDL", corrections},
            {"every file", {}}};
}

bool is_shown(const FileKind& kind, const std::string& name) {
    return kind.extensions.empty() ||
           std::find(kind.extensions.begin(), kind.extensions.end(),
                     lutlib::io::extension_of(name)) != kind.extensions.end();
}

/// Letters of ASCII alike in both cases; else by their bytes, so that there is one order.
std::string sorted_as(const std::string& name) {
    std::string out = name;
    std::transform(out.begin(), out.end(), out.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return out + '\0' + name;
}

} // namespace

std::span<const FileKind> file_kinds() {
    static const std::vector<FileKind> all = kinds();
    return all;
}

FolderList list_folder(const std::string& folder, const FileKind& kind) {
    FolderList out;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end;
         at.increment(failed)) {
        const std::string name = at->path().filename().string();
        std::error_code unknown; // a link that leads nowhere
        const bool is_folder = at->is_directory(unknown);
        if (!name.starts_with('.') && (is_folder || is_shown(kind, name))) {
            out.entries.push_back({name, is_folder});
        }
    }
    if (failed) {
        return {{},
                "choose another folder, for " + folder + " cannot be read: " + failed.message()};
    }
    std::sort(
        out.entries.begin(), out.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
            return a.is_folder != b.is_folder ? a.is_folder : sorted_as(a.name) < sorted_as(b.name);
        });
    return out;
}

std::string path_in(const std::string& folder, const std::string& typed) {
    const char* const home = std::getenv("HOME");
    const bool is_of_home = home != nullptr && (typed == "~" || typed.starts_with("~/"));
    const fs::path named =
        is_of_home ? fs::path(home) / typed.substr(std::min<std::size_t>(2, typed.size()))
                   : fs::path(typed);
    std::string out = (fs::path(folder) / named).lexically_normal().string();
    while (out.size() > 1 && out.back() == '/') {
        out.pop_back();
    }
    return out;
}

void remember_file(std::vector<std::string>& recent, const std::string& path) {
    std::error_code unknown;
    const std::string whole = fs::absolute(path, unknown).lexically_normal().string();
    if (unknown) {
        return;
    }
    recent.erase(std::remove(recent.begin(), recent.end(), whole), recent.end());
    recent.insert(recent.begin(), whole);
    recent.resize(std::min(recent.size(), most_recent_files));
}

} // namespace preview::editor
