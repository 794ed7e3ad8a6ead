// Any bytes as a LUT picture: read or refused with an Error; what was read has finite nodes.
#include "lutlib/error.h"
#include "lutlib/io/lut_picture.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        validate(lutlib::io::read_lut_picture(bytes, "fuzz.png"));
    } catch (const lutlib::Error&) {
    }
    return 0;
}
