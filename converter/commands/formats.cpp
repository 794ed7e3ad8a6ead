// lutconv formats: the LUT files that are read and written.
#include "lutlib/io/formats.h"
#include "converter/listing_verb.h"
#include "converter/listings.h"

#include <nlohmann/json.hpp>

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

terminal::Table formats_table() {
    terminal::Table out;
    for (const lutlib::FileFormat* const format : lutlib::io::file_formats()) {
        const bool reads = format->read || format->read_in_pieces, writes = format->write;
        out.row({std::string(format->name),
                 reads && writes ? "read, write"
                 : reads         ? "read"
                                 : "write",
                 extensions_of(*format), std::string(format->label)});
    }
    return out;
}

} // namespace

Run declare_formats(Verb& verb) {
    return declare_listing(verb, "what each can hold", formats_table, formats_json);
}

} // namespace converter
