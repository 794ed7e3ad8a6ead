#include "lutlib/io/temporary_file.h"

#include "lutlib/error.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace lutlib::io {
namespace {

void remove_folder(const std::string& folder) {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
}

std::string new_folder() {
    std::error_code error;
    std::string folder = (std::filesystem::temp_directory_path(error) / "lutlib-XXXXXX").string();
    if (error || !::mkdtemp(folder.data())) {
        const int reason = error ? error.value() : errno;
        throw Error("cannot create a folder for temporary files; TMPDIR can name a writable place "
                    "for it: " +
                    std::generic_category().message(reason));
    }
    return folder;
}

// OpenColorIO expands "$" and "%" as variables, OpenImageIO "%" and "#" as frame numbers, and the
// file system takes 255 bytes.
std::string harmless(const std::string& name) {
    constexpr std::size_t most_bytes = 200;
    std::string out;
    for (const char c : name.substr(0, most_bytes)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_' || c == ' ';
        out += plain ? c : '_';
    }
    return out;
}

std::string name_in_folder(const std::string& name, const std::string& extension) {
    const std::filesystem::path path(name);
    const std::string own = path.extension().string();
    const std::string stem = harmless(path.stem().string());
    return (stem.empty() ? "input" : stem) + (extension.empty() ? own : "." + extension);
}

} // namespace

TemporaryFile::TemporaryFile(std::string_view bytes, const std::string& name,
                             const std::string& extension)
    : folder_(new_folder()), path_(folder_ + "/" + name_in_folder(name, extension)),
      folder_removed_(folder_), file_removed_(path_) {
    std::ofstream file(path_, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) {
        remove_folder(folder_);
        throw Error("cannot write a temporary file; is its disk full?", {path_, 0, {}});
    }
}

TemporaryFile::~TemporaryFile() {
    remove_folder(folder_);
}

} // namespace lutlib::io
