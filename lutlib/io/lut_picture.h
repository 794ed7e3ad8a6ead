// LUT pictures as PNG files: an engine's baked lattice out, any recognised layout in.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/io/png.h"

#include <optional>
#include <string>
#include <string_view>

namespace lutlib::io {

/// What the PNG's text says of where it came from.
struct BakeOrigin {
    std::string source;
    std::string title;
    std::string_view interpolation;
    bool fitted = false; ///< to the engine's lookup, rather than sampled at the nodes
};

/// The file's bytes, with the engine's sRGB tag and text entries Source, Title, Engine,
/// Interpolation, Lattice ("fitted" or "point-sampled") and Software.
std::string picture_bytes(const Bake& bake, const BakeOrigin& origin);

/// The RGB codes of a PNG, alpha left out.
CodeImage code_picture(const PngImage& image);

/// A text entry of a PNG, if it has one.
std::optional<std::string> text_entry(const PngImage& image, std::string_view key);

} // namespace lutlib::io
