// Any bytes as a .cube: read or refused with an Error, and what was read is written and read back
// bit-identically.
#include "lutlib/error.h"
#include "lutlib/formats/cube.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    lutlib::Lut lut;
    try {
        lut = lutlib::read_cube(bytes, "fuzz.cube");
    } catch (const lutlib::Error&) {
        return 0;
    }
    const auto scalar = [](const lutlib::Domain& d) {
        return d.min.r == d.min.g && d.min.g == d.min.b && d.max.r == d.max.g && d.max.g == d.max.b;
    };
    const bool both = lut.shaper && lut.cube;
    if (both && !(scalar(lut.shaper->domain) && scalar(lut.cube->domain))) {
        return 0; // No dialect can say it; the writer's refusal has a unit test.
    }
    const std::string text = write_cube(lut, best_dialect(lut));
    const lutlib::Lut again = lutlib::read_cube(text, "again.cube");
    if (!(again.shaper == lut.shaper) || !(again.cube == lut.cube)) {
        std::abort();
    }
    return 0;
}
