// Any bytes as ASC CDL corrections: read or refused with an Error; what was read is written and
// read back the same, beside the others of its file, and gives an operator within its ranges.
#include "lutlib/error.h"
#include "lutlib/recipe/correction_file.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace {

void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

void try_written(const lutlib::ColorCorrection& correction) {
    try {
        for (const lutlib::CorrectionFormat& format : lutlib::correction_formats()) {
            const std::string text = correction_text(correction, format);
            const auto again = lutlib::parse_corrections(text, "again");
            require(again.size() == 1 && again[0] == correction);
            require(lutlib::is_correction_text(text, "again"));
        }
    } catch (const lutlib::UsageError&) { // an id that XML cannot hold
    }
}

void try_operator(const lutlib::ColorCorrection& correction) {
    std::vector<lutlib::Loss> losses;
    const lutlib::Operation operation = operation_of(correction, losses);
    for (std::size_t i = 0; i < operation.values.size(); ++i) {
        require(problem_with(operation.op->parameters[i], operation.values[i]).empty());
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const auto read = lutlib::parse_corrections(bytes, "fuzz.ccc");
        require(!read.empty());
        for (const lutlib::ColorCorrection& correction : read) {
            try_written(correction);
            try_operator(correction);
        }
        const lutlib::ColorCorrection added{.id = "added", .saturation = 2};
        const auto longer =
            lutlib::parse_corrections(lutlib::with_correction(bytes, "fuzz.ccc", added), "longer");
        require(std::find(longer.begin(), longer.end(), added) != longer.end());
        require(longer.size() == read.size() || longer.size() == read.size() + 1);
    } catch (const lutlib::Error&) {
    }
    return 0;
}
