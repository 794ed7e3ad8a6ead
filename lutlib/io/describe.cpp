#include "lutlib/io/describe.h"

#include "lutlib/number_text.h"

namespace lutlib::io {
namespace {

std::string triple(const Rgb& c) {
    return c.r == c.g && c.g == c.b ? shortest(c.r)
                                    : shortest(c.r) + "," + shortest(c.g) + "," + shortest(c.b);
}

} // namespace

std::string text_of(const Domain& domain) {
    return triple(domain.min) + ".." + triple(domain.max);
}

std::string shape_of(const Lut& lut) {
    const std::string curve =
        lut.shaper ? "a curve of " + std::to_string(lut.shaper->size()) + " entries" : "";
    const std::string cube =
        lut.cube ? "a cube of " + std::to_string(lut.cube->size) + " nodes per axis" : "";
    return curve.empty() && cube.empty()
               ? "no table"
               : curve + (curve.empty() || cube.empty() ? "" : " and ") + cube;
}

} // namespace lutlib::io
