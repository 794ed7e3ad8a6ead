// Which layout a LUT picture has, told from its content: dimensions alone cannot (a 16-node
// ociolutimage picture has exactly Unreal's size with green and blue swapped).
//
// Two questions, each with its own measure (evidence.h). Geometry: which reading is smooth along
// all three axes, while the picture, unlike a photograph, jumps where one row of nodes ends and the
// next begins? Orientation, among those that are: in which do greys stay grey and hues keep
// their order? A look without colour answers only the first, and is refused unless something else
// names its layout.
#pragma once

#include "lutlib/engine/layout.h"

#include <span>
#include <string>
#include <vector>

namespace lutlib {

/// One way of reading a picture as lattices, and what its content says to that; of stacked lattices
/// the worst that any of them says.
struct Recognition {
    const Layout* layout = nullptr;
    int size = 0;
    int rows = 1;             ///< lattices stacked below each other
    double roughness = 1;     ///< Evidence::roughness
    double fold = 0;          ///< how much more the picture jumps where a row of nodes ends
    double grey_drift = 0;    ///< Evidence::grey_drift
    double orientation = 0;   ///< hue order less grey drift: 1 at best; 0 without colour
    double ownership = 0;     ///< Evidence::ownership, the mean of all
    bool tells_hues = false;  ///< the look has hues that can be in order
    bool tones_agree = false; ///< it grows brighter along all three axes, or darker along all
    bool falls = false;       ///< it grows darker along all three axes, as a negative does
};

/// Every reading that the dimensions allow, smoothest first. Empty: no layout has these dimensions.
std::vector<Recognition> recognise(const Picture& picture);

/// Of those, the one that the content shows: smooth by itself, at least 2.5 times smoother than
/// what is not oriented as well, and with greys and hues in clearly better order than the next. The
/// ocio layout, whose pictures are strips with green and blue swapped, must also be the more usual
/// look of the two. Null: the content does not tell.
const Recognition* shown_by_content(std::span<const Recognition> readings);

/// What is known of a picture's layout beside its content: it decides where content does not tell.
struct LayoutHint {
    const Layout* layout = nullptr;
    std::string source; ///< who says so, as a clause: "its text names the engine unity"
};

struct Recognised {
    Recognition reading;
    /// A hint that the content contradicts and that was not followed, in a sentence; else empty.
    std::string contradiction;
    /// Why it may be meant otherwise, in a sentence; else empty.
    std::string doubt = {};
};

/// Throws Error where neither content nor hint tells; it names the candidates and what decides.
Recognised recognise_one(const Picture& picture, const std::string& file,
                         const LayoutHint& hint = {});

} // namespace lutlib
