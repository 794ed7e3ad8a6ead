#include "converter/replaceable.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/png.h"

#include <filesystem>
#include <string_view>

namespace converter {
namespace {

namespace io = lutlib::io;

constexpr std::string_view own_mark = "lutconv";

// Other pictures than PNG keep their text at either end.
bool says_so(std::string_view bytes) {
    constexpr std::size_t near_an_end = 1 << 16;
    return bytes.substr(0, near_an_end).find(own_mark) != std::string_view::npos ||
           (bytes.size() > near_an_end &&
            bytes.substr(bytes.size() - near_an_end).find(own_mark) != std::string_view::npos);
}

// LUT files have no place for a mark that every other program skips. Written once more, none of
// ours changes by a byte.
bool is_as_written(const std::string& bytes, const std::string& path) {
    try {
        const lutlib::FileFormat& format = io::recognise_format(bytes, path);
        return format.write &&
               io::encode_lut(io::decode_lut(bytes, path).lut, format).bytes == bytes;
    } catch (const lutlib::Error&) {
        return false;
    }
}

} // namespace

void declare_force(Verb& verb, bool& force) {
    verb.add_flag("--force", force,
                  "overwrite a file that lutconv did not make, or one that this run reads");
}

bool is_of_own_making(const std::string& bytes, const std::string& path) {
    return bytes.empty() || (io::is_png(bytes) ? io::is_own_picture(path)
                                               : says_so(bytes) || is_as_written(bytes, path));
}

void require_replaceable(const std::string& path, const std::vector<std::string>& inputs,
                         bool force) {
    std::error_code none;
    if (force || path.empty() || path == io::standard_stream ||
        !std::filesystem::is_regular_file(path, none) ||
        std::filesystem::file_size(path, none) == 0) {
        return;
    }
    for (const std::string& input : inputs) {
        if (!input.empty() && std::filesystem::equivalent(path, input, none)) {
            throw lutlib::Error("it is what this run reads; name another file, or add --force to "
                                "overwrite it",
                                {path, 0, {}});
        }
    }
    if (!is_of_own_making(io::read_file(path), path)) {
        throw lutlib::Error("it is a file that lutconv did not make; name another, or add --force "
                            "to overwrite it",
                            {path, 0, {}});
    }
}

} // namespace converter
