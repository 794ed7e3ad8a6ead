#include "lutlib/io/describe.h"

#include <array>
#include <charconv>

namespace lutlib::io {
namespace {

std::string number(float value) {
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string triple(const Rgb& c) {
    return c.r == c.g && c.g == c.b ? number(c.r)
                                    : number(c.r) + "," + number(c.g) + "," + number(c.b);
}

} // namespace

std::string text_of(const Domain& domain) {
    return triple(domain.min) + ".." + triple(domain.max);
}

std::string shape_of(const Lut& lut) {
    const std::string curve =
        lut.shaper ? "a curve of " + std::to_string(lut.shaper->size()) + " entries" : "";
    const std::string cube =
        lut.cube ? "a cube of " + std::to_string(lut.cube->size) + " nodes a side" : "";
    return curve.empty() && cube.empty()
               ? "no table"
               : curve + (curve.empty() || cube.empty() ? "" : " and ") + cube;
}

} // namespace lutlib::io
