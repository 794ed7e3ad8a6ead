#include "lutlib/io/ocio.h"

#include "lutlib/io/file.h"
#include "lutlib/io/temporary_file.h"

#include <filesystem>
#include <system_error>

namespace lutlib::io {
namespace {

// Corrections of a .ccc or .cdl collection; 0 for other files.
std::size_t corrections_in(std::string_view bytes) {
    // Not the collection's own name, which begins alike.
    constexpr std::string_view name = "ColorCorrection", before = "<:", behind = " \t\r\n>/";
    std::size_t count = 0;
    for (std::size_t at = bytes.find(name); at != std::string_view::npos;
         at = bytes.find(name, at + name.size())) {
        const std::size_t end = at + name.size();
        const bool opens = at > 0 && before.find(bytes[at - 1]) != std::string_view::npos &&
                           !bytes.substr(0, at).ends_with("</");
        count += opens && end < bytes.size() && behind.find(bytes[end]) != std::string_view::npos;
    }
    return count;
}

} // namespace

// OpenColorIO reads only by path, expands "$" and "%" in it as variables and remembers what it read
// under it. A file of our own in a folder of our own has none of these troubles; its name stays,
// for a Discreet 1D .lut says its depth there.

Transform Ocio::parse(std::string_view bytes, const std::string& extension, const std::string& file,
                      const EvaluationOptions& options) const {
    const TemporaryFile copy(bytes, file, extension);
    return parse_at(copy.path(), file, options);
}

Reading Ocio::read(std::string_view bytes, const std::string& extension, const std::string& file,
                   const ReadOptions& options) const {
    const TemporaryFile copy(bytes, file, extension);
    Reading out = read_at(copy.path(), file, options);
    if (const std::size_t count = corrections_in(bytes); count > 1) {
        out.losses.push_back({"only the first colour correction is read, of",
                              static_cast<double>(count), "corrections"});
    }
    return out;
}

std::optional<Transform> Ocio::open(const std::string& path,
                                    const EvaluationOptions& options) const {
    std::error_code error;
    const std::string absolute = std::filesystem::absolute(path, error).string();
    if (!std::filesystem::is_regular_file(path, error) ||
        absolute.find_first_of("$%") != absolute.npos) {
        return std::nullopt;
    }
    return parse_at(absolute, path, options);
}

Transform open_in_ocio(const std::string& path, const EvaluationOptions& options) {
    const auto own = ocio().open(path, options);
    return own ? *own : ocio().parse(read_file(path), extension_of(path), path, options);
}

} // namespace lutlib::io
