// Pictures that were turned by quarters or mirrored, and back.
#pragma once

#include "lutlib/engine/layout.h"

#include <string>
#include <vector>

namespace lutlib {

/// First turned by so many quarters clockwise, then mirrored upside down.
struct Turn {
    int quarters = 0; ///< 0..3
    bool mirrored = false;

    friend bool operator==(const Turn&, const Turn&) = default;
};

/// All eight; the one that leaves a picture as it is comes first.
std::vector<Turn> all_turns();

/// The extent of a picture that was turned.
PictureSize turned(PictureSize size, Turn turn);
/// Of a pixel of the turned picture, the one that it was in a picture of this size.
Pixel before_turn(Pixel at, PictureSize size, Turn turn);
/// Where a pixel of a picture of this size is once that is turned.
Pixel after_turn(Pixel at, PictureSize size, Turn turn);

Picture turned(const Picture& picture, Turn turn);
/// The same of one value a pixel.
std::vector<float> turned(const std::vector<float>& plane, PictureSize size, Turn turn);

/// What makes a picture upright again, in words; empty where it is.
std::string words_of(Turn turn);

} // namespace lutlib
