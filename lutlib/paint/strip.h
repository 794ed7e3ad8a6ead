// A strip found in a graded picture, and the look that it holds.
#pragma once

#include "lutlib/paint/frame.h"
#include "lutlib/paint/turn.h"

#include <optional>
#include <string>
#include <vector>

namespace lutlib {

struct FoundStrip {
    Framed framed;
    PictureSize extent;           ///< of the strip, upright
    Turn turn;                    ///< that makes the picture upright
    Pixel at;                     ///< of the strip's upper left pixel in the upright picture
    std::optional<Pixel> mark_at; ///< the same of its mark; none: found without
    double scale = 1;             ///< of its mark, against the size in which it was placed
    bool falls = false;           ///< found without a mark, it is a negative
    bool may_be_negative = false; ///< as of BareStrip
};

/// What narrows a search.
struct StripSearch {
    const Layout* layout = nullptr; ///< null: any
    int size = 0;                   ///< 0: any
    std::optional<Pixel> around;    ///< a pixel, of the picture as it is, that the strip covers
    int bits = 8;                   ///< of the codes that a strip without a mark was placed with
};

/// Every strip: those with a mark, or where there is none those without.
std::vector<FoundStrip> find_strips(const Picture& picture, const StripSearch& search = {});

/// The pixels of the strip, and of its frame where it has a mark, that lie in the upright picture.
struct Area {
    int left = 0, top = 0, right = 0, bottom = 0; ///< right and bottom are beyond

    bool holds(int x, int y) const { return x >= left && x < right && y >= top && y < bottom; }
    bool is_within(PictureSize size) const {
        return left >= 0 && top >= 0 && right <= size.width && bottom <= size.height;
    }
};
Area strip_area(const FoundStrip& strip);
Area frame_area(const FoundStrip& strip);

/// The strip's colours as nodes at i / (size - 1): read where they stand, and carried along
/// straight lines from the codes that were placed, which are rounded, to there. The strip must lie
/// within the upright picture.
Lut3D lattice_in(const Picture& upright, const FoundStrip& strip);

} // namespace lutlib
