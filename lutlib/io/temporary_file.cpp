#include "lutlib/io/temporary_file.h"

#include "lutlib/error.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace lutlib::io {
namespace {

void remove_folder(const std::string& folder) {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
}

} // namespace

TemporaryFile::TemporaryFile(std::string_view bytes, const std::string& extension)
    : folder_((std::filesystem::temp_directory_path() / "lutlib-XXXXXX").string()) {
    if (!::mkdtemp(folder_.data())) {
        throw Error("cannot create a temporary folder; is TMPDIR writable?", {folder_, 0, {}});
    }
    path_ = folder_ + "/input" + (extension.empty() ? "" : "." + extension);
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
