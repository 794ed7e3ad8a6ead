// Imageworks .spi1d: a curve.
//
//   "Version 1" / "From" min max / "Length" n / "Components 3" / "{" / n rows r g b / "}"
//
// OpenColorIO reads it, and its reader is the source of this grammar; we write the shortest
// decimals that read back bit-identically.

#include "lutlib/error.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/formats/opencolorio.h"
#include "lutlib/number_text.h"

namespace lutlib::formats {
namespace {

std::string write_spi1d(const FileFormat& /*format*/, const Lut& lut,
                        const WriteOptions& /*options*/) {
    validate(lut);
    if (!lut.shaper || lut.cube) {
        throw Error("an .spi1d file holds one curve and nothing else");
    }
    const Domain& domain = lut.shaper->domain;
    if (domain.min != Rgb{domain.min.r, domain.min.r, domain.min.r} ||
        domain.max != Rgb{domain.max.r, domain.max.r, domain.max.r}) {
        throw Error("an .spi1d file has one input range for all channels; this look's differ");
    }
    std::string out = "Version 1\nFrom ";
    append_number(out, domain.min.r, Exponents::allowed);
    out += ' ';
    append_number(out, domain.max.r, Exponents::allowed);
    out += "\nLength " + std::to_string(lut.shaper->size()) + "\nComponents 3\n{\n";
    append_rows(out, lut.shaper->entries, Exponents::allowed);
    return out + "}\n";
}

} // namespace

constinit const FileFormat spi1d = read_by_opencolorio({
    .name = "spi1d",
    .label = "Imageworks .spi1d: a curve",
    .extensions = {"spi1d"},
    .holds = {.curve = true, .curve_domain = true},
    .magic = "Components",
    .write = write_spi1d,
});

} // namespace lutlib::formats
