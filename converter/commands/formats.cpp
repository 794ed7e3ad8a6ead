// lutconv formats: the LUT files that are read and written.
#include "lutlib/io/formats.h"
#include "converter/listing_verb.h"
#include "converter/listings.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace converter {
namespace {

std::string extensions_of(const lutlib::FileFormat& format) {
    std::string out;
    for (const std::string_view extension : format.extensions) {
        out += (out.empty() ? "." : " .") + std::string(extension);
    }
    return out;
}

std::string as_text() {
    std::size_t names = 0, extensions = 0;
    for (const lutlib::FileFormat* const format : lutlib::io::file_formats()) {
        names = std::max(names, format->name.size());
        extensions = std::max(extensions, extensions_of(*format).size());
    }
    std::string out;
    for (const lutlib::FileFormat* const format : lutlib::io::file_formats()) {
        const bool reads = format->read || format->read_in_pieces, writes = format->write;
        out += fmt::format("{:<{}}  {:<11}  {:<{}}  {}\n", format->name, names,
                           reads && writes ? "read, write"
                           : reads         ? "read"
                                           : "write",
                           extensions_of(*format), extensions, format->label);
    }
    return out;
}

} // namespace

Run declare_formats(Verb& verb) {
    return declare_listing(verb, "what each can hold", as_text, formats_json);
}

} // namespace converter
