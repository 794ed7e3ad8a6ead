// Finds strips without a mark in a picture by what all their layouts have in common: rows of
// colours that run smoothly over as many pixels as there are nodes, jump, and begin anew.
#pragma once

#include "lutlib/engine/recognise.h"
#include "lutlib/paint/turn.h"

#include <vector>

namespace lutlib {

struct BareStrip {
    const Layout* layout = nullptr;
    int size = 0;
    PictureSize extent; ///< of the strip, upright
    Turn turn;          ///< that makes the picture upright
    Pixel at;           ///< of the strip's upper left pixel in the upright picture
    bool falls = false; ///< it is a negative
    /// Turned by 180 degrees it would be a negative; nothing tells which of the two it is.
    bool may_be_negative = false;
};

struct BareSearch {
    const Layout* layout = nullptr; ///< the only one that is looked for; null: every one
    int size = 0;                   ///< the same of nodes; 0: from 8 to 65
};

/// Every strip that the content shows (recognise.h), the smoothest first where two overlap. The
/// picture may be the strip alone, then of any size.
std::vector<BareStrip> find_bare(const Picture& picture, const BareSearch& search = {});

} // namespace lutlib
