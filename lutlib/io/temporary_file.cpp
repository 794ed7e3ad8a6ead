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

} // namespace

TemporaryFile::TemporaryFile(std::string_view bytes, const std::string& extension)
    : folder_(new_folder()), path_(folder_ + "/input" + (extension.empty() ? "" : "." + extension)),
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
