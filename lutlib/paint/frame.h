// A neutral strip on its way through a paint program: a quiet border of one grey around it, and a
// mark above it that says in dark and light cells what lies below.
//
// The mark survives whatever leaves its two greys apart. Along each of its two rows of cells run 13
// that are the same in every mark (Barker's code, whose copies beside itself hardly agree), the
// row, the layout, the size, the depth of its codes, and a check sum; so a row tells its own
// direction, and both together which way is up.
#pragma once

#include "lutlib/code_image.h"
#include "lutlib/engine/layout.h"

#include <array>
#include <optional>
#include <vector>

namespace lutlib {

inline constexpr int mark_cell = 4;    ///< pixels, each way
inline constexpr int quiet_width = 16; ///< pixels of border around the mark and around the strip
inline constexpr int mark_cells = 35;
inline constexpr int sync_cells = 13;

/// In codes of 8 bits; of others so many 255ths of the largest, which 16 bits hold exactly.
inline constexpr int quiet_code = 128, dark_code = 64, light_code = 192;

/// What lies in a frame.
struct Framed {
    const Layout* layout = nullptr;
    int size = 0;
    int bits = 8; ///< of the codes that it was placed with: 8 or 16

    friend bool operator==(const Framed&, const Framed&) = default;
};

using MarkRow = std::array<bool, mark_cells>; ///< true: light

/// Row 0 or 1 of a mark.
MarkRow mark_row(const Framed& framed, int row);
/// Of the cells of a row, which row it is and what it says; nullopt where the check sum differs or
/// it says what there is not.
struct MarkReading {
    Framed framed;
    int row = 0;
};
std::optional<MarkReading> read_mark(const MarkRow& cells);

/// Where things lie in a frame, in pixels from its upper left corner. Throws Error where the layout
/// has no picture of the size.
struct FrameGeometry {
    PictureSize strip, frame;
    Pixel mark_at, strip_at;
};
FrameGeometry geometry_of(const Framed& framed);

/// The frame with its neutral strip, whose node i holds i / (size - 1) rounded to a code.
CodeImage neutral_frame(const Framed& framed);

} // namespace lutlib
