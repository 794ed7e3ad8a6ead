// The descriptor of a LUT file format, and of what a format can hold.
#pragma once

#include "lutlib/lut.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

/// One thing that a conversion could not keep, with its figure: {"domain 0..4 cut to 0..1", 3,
/// "of 4 units of input"}. A list of them is printed, and is an error under --strict.
struct Loss {
    std::string what;
    double figure = 0;
    std::string unit;
};

/// What a file of a format can say. A Lut is fitted to it before it is written.
struct Holds {
    bool curve = false;              ///< a 1D table alone
    bool cube = false;               ///< a 3D table alone
    bool curve_and_cube = false;     ///< a shaper followed by a cube
    bool curve_domain = false;       ///< an input interval of the 1D table other than 0..1
    bool cube_domain = false;        ///< an input interval of the cube other than 0..1
    bool per_channel_domain = false; ///< the interval may differ between channels
    bool title = false;
    bool keywords = false; ///< Lut::keywords
    int integer_bits = 0; ///< codes of so many bits over 0..1, values outside clamped; 0: float
    int decimals = 0;     ///< decimals of a text format that rounds; 0: every bit kept
};

struct WriteOptions {
    std::string title; ///< replaces the look's own when not empty
};

/// One row of a format table. `read` and `write` are null where the format is write- or read-only.
struct Format {
    std::string_view name;                        ///< as in --format
    std::string_view label;                       ///< for help
    std::span<const std::string_view> extensions; ///< lower case, without the dot, first is default
    /// How surely these bytes (the whole file or its head) are of this format: 0 no .. 100 yes.
    int (*sniff)(std::string_view bytes) = nullptr;
    /// Parses a whole file. `file` names it in errors. Throws Error.
    Lut (*read)(std::string_view bytes, const std::string& file) = nullptr;
    /// The file's bytes. Expects a Lut that `holds` can hold; throws Error otherwise.
    std::string (*write)(const Lut& lut, const WriteOptions& options) = nullptr;
    Holds holds;
};

} // namespace lutlib
