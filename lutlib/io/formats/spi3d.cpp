// Imageworks .spi3d: a cube.
//
//   "SPILUT 1.0" / "3 3" / N N N / N^3 rows: ir ig ib r g b
//
// OpenColorIO reads it, and its reader is the source of this grammar; we write the shortest
// decimals that read back bit-identically.

#include "lutlib/error.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/formats/opencolorio.h"
#include "lutlib/number_text.h"

namespace lutlib::formats {
namespace {

std::string write_spi3d(const FileFormat& /*format*/, const Lut& lut,
                        const WriteOptions& /*options*/) {
    validate(lut);
    if (!lut.cube || lut.shaper || !lut.cube->domain.is_unit()) {
        throw Error("an .spi3d file holds one cube of input 0..1 and nothing else");
    }
    const std::string n = std::to_string(lut.cube->size);
    std::string out = "SPILUT 1.0\n3 3\n" + n + ' ' + n + ' ' + n + '\n';
    // Blue fastest, as the format's own files are; the indices say it anyway.
    for (int r = 0; r < lut.cube->size; ++r) {
        for (int g = 0; g < lut.cube->size; ++g) {
            for (int b = 0; b < lut.cube->size; ++b) {
                out += std::to_string(r) + ' ' + std::to_string(g) + ' ' + std::to_string(b) + ' ';
                append_row(out, lut.cube->at(r, g, b), Exponents::allowed);
            }
        }
    }
    return out;
}

} // namespace

constinit const FileFormat spi3d = read_by_opencolorio({
    .name = "spi3d",
    .label = "Imageworks .spi3d: a cube",
    .extensions = {"spi3d"},
    .holds = {.cube = true},
    .magic = "SPILUT",
    .write = write_spi3d,
});

} // namespace lutlib::formats
