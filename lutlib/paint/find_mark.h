// Finds the marks of framed strips in a picture, whatever grade, turn or scale it went through.
#pragma once

#include "lutlib/paint/frame.h"
#include "lutlib/paint/turn.h"

#include <vector>

namespace lutlib {

struct FoundMark {
    Framed framed;
    Turn turn;        ///< that makes the picture upright
    Pixel at;         ///< of the mark's upper left pixel in the upright picture
    double scale = 1; ///< against the size in which it was placed
};

/// At the scale in which marks are placed; where there is none, at every scale from 0.4 to 4, which
/// then is known to about a hundredth. Two greys are told apart from a contrast of five codes of 8
/// bits on.
std::vector<FoundMark> find_marks(const Picture& picture);

/// The picture in which each square of 2x2, 3x3 or 4x4 equal pixels has become one, with the length
/// of their side; nothing where it is made of no such squares.
struct Reduced {
    Picture picture;
    int by = 1;
};
std::optional<Reduced> reduced(const Picture& picture);

} // namespace lutlib
