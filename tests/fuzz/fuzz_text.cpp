// Any bytes as a LUT in each of lutlib's own text formats, and as the damaged .cube that `check`
// looks at: read or refused with an Error.
#include "lutlib/error.h"
#include "lutlib/formats/all.h"
#include "lutlib/formats/cube.h"
#include "lutlib/io/formats/all.h"

#include <cstdint>

namespace formats = lutlib::formats;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    for (const lutlib::FileFormat* const format :
         {&formats::flame, &formats::lustre, &formats::azasset, &formats::csp, &formats::spi1d,
          &formats::spi3d}) {
        try {
            if (format->read) {
                validate(
                    format->read(*format, bytes, "fuzz." + format->extensions.first(), {}).lut);
            }
        } catch (const lutlib::Error&) {
        }
    }
    try {
        lutlib::read_broken_cube(bytes, "fuzz.cube");
    } catch (const lutlib::Error&) {
    }
    return 0;
}
