#include "converter/usage.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"

#include <algorithm>

namespace converter {

std::string standard_output_of(std::span<const std::string> outputs) {
    const auto count = std::count(outputs.begin(), outputs.end(), lutlib::io::standard_stream);
    if (count > 1) {
        throw lutlib::UsageError("only one output can be standard output; name files for the rest");
    }
    return count > 0 ? std::string(lutlib::io::standard_stream) : std::string();
}

} // namespace converter
