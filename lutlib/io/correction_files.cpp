#include "lutlib/io/correction_files.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/terminal.h"
#include "lutlib/recipe/correction_file.h"

#include <filesystem>

namespace lutlib::io {
namespace {

constexpr std::size_t most_bytes = std::size_t{64} << 20U;

} // namespace

std::vector<ColorCorrection> read_corrections(const std::string& path) {
    return parse_corrections(read_file(path, most_bytes), input_name(path));
}

std::string correction_bytes(const std::string& path, const ColorCorrection& correction,
                             Unreadable there) {
    const CorrectionFormat* const format = correction_format_of(path);
    if (format == nullptr) {
        throw UsageError("end the name of a correction's file in .cc, .ccc or .cdl: '" +
                         output_name(path) + "' says nothing of its format");
    }
    if (!is_utf8(correction.id) || !is_utf8(correction.description)) {
        throw UsageError("write the correction's id in UTF-8, as its file is");
    }
    std::error_code unknown;
    const bool is_there =
        std::filesystem::exists(path, unknown) && std::filesystem::file_size(path, unknown) != 0;
    if (format->holds_many() && is_there) {
        try {
            return with_correction(read_file(path, most_bytes), path, correction);
        } catch (const UsageError&) { // of the correction
            throw;
        } catch (const Error&) {
            if (there == Unreadable::is_an_error) {
                throw;
            }
        }
    }
    return correction_text(correction, *format);
}

} // namespace lutlib::io
