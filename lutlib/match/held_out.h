// Which part of a picture a look is not learnt from, to be measured on.
#pragma once

namespace lutlib {

/// Every eighth tile of 16x16 pixels, so that what is measured are other places, not neighbours of
/// pixels that were learnt from. A picture of less than 33x17 pixels or so has none.
constexpr bool is_held_out(int x, int y) {
    constexpr int tile = 16, every = 8, shift = 3, first = 5;
    return (x / tile + shift * (y / tile)) % every == first;
}

} // namespace lutlib
