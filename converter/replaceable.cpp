#include "converter/replaceable.h"

#include "converter/stiff_page.h"
#include "converter/survey_page.h"
#include "lutlib/error.h"
#include "lutlib/io/extension.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/io/png.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/recipe/correction_file.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace converter {
namespace {

namespace io = lutlib::io;

using namespace std::string_view_literals;

// A text entry of a PNG, and what other files say near one of their ends.
constexpr std::string_view own_entry = "Software\0lutconv"sv, own_mark = "lutconv";
constexpr std::size_t near_an_end = 1 << 16;

bool forced_run = false;

bool says_so(std::string_view bytes) {
    const std::string_view mark = io::is_png(bytes) ? own_entry : own_mark;
    return bytes.substr(0, near_an_end).find(mark) != std::string_view::npos ||
           (bytes.size() > near_an_end &&
            bytes.substr(bytes.size() - near_an_end).find(mark) != std::string_view::npos);
}

// Of pictures, which may be large and many, both ends.
std::string bytes_that_tell(const std::string& path) {
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(path, none);
    if (none || size <= 2 * near_an_end || !io::is_picture_extension(io::extension_of(path))) {
        return io::read_file(path);
    }
    std::ifstream file(path, std::ios::binary);
    std::string out(2 * near_an_end, '\0');
    file.read(out.data(), near_an_end);
    file.seekg(-static_cast<std::streamoff>(near_an_end), std::ios::end);
    file.read(out.data() + near_an_end, near_an_end);
    return file ? out : io::read_file(path);
}

// LUT files have no place for a mark that every other program skips, and recipes need none. Written
// once more, none of ours changes by a byte.
bool is_as_written(const std::string& bytes, const std::string& path) {
    try {
        if (io::is_recipe(bytes)) {
            return to_json(lutlib::parse_recipe(bytes, path)) == bytes;
        }
        if (lutlib::correction_format_of(path) != nullptr) {
            return lutlib::is_correction_text(bytes, path);
        }
        const lutlib::FileFormat& format = io::recognise_format(bytes, path);
        return format.write &&
               io::encode_lut(io::decode_lut(bytes, path).lut, format).bytes == bytes;
    } catch (const lutlib::Error&) {
        return false;
    }
}

// A table of figures has no place for a mark either.
bool is_own_table(std::string_view bytes) {
    return bytes.starts_with(survey_csv_head()) || bytes.starts_with(stiff_csv_head());
}

} // namespace

void declare_force(Verb& verb, bool& force) {
    verb.add_flag("--force", force,
                  "overwrite files that lutconv did not make, or that this run reads");
}

void set_force(bool force) {
    forced_run = force;
}

bool is_of_own_making(const std::string& bytes, const std::string& path) {
    return bytes.empty() || says_so(bytes) ||
           (!io::is_png(bytes) && (is_own_table(bytes) || is_as_written(bytes, path)));
}

void require_replaceable(const std::string& path, const std::vector<std::string>& inputs) {
    std::error_code none;
    if (forced_run || path.empty() || path == io::standard_stream ||
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
    if (!is_of_own_making(bytes_that_tell(path), path)) {
        throw lutlib::Error("it is a file that lutconv did not make; name another, or add --force "
                            "to overwrite it",
                            {path, 0, {}});
    }
}

void require_replaceable(const Verb& verb) {
    const std::vector<std::string> inputs = verb.other_values();
    for (const std::string& output : verb.outputs()) {
        require_replaceable(output, inputs);
    }
}

void require_replaceable(std::span<const io::Route> routes) {
    for (const io::Route& route : routes) {
        require_replaceable(route.to, {route.from.path});
    }
}

} // namespace converter
