// Any bytes as a LUT picture: read or refused with an Error; what was read has finite nodes.
#include "lutlib/error.h"
#include "lutlib/io/formats/all.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const lutlib::FileFormat& format = lutlib::formats::png;
        validate(format.read(format, bytes, "fuzz.png", {}).lut);
    } catch (const lutlib::Error&) {
    }
    return 0;
}
