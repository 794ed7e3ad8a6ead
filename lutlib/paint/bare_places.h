// Where in a picture rows of colours run smoothly over as many pixels as a lattice has nodes, jump,
// and begin anew, as in every layout of a strip.
#pragma once

#include "lutlib/engine/recognise.h"
#include "lutlib/paint/turn.h"

#include <vector>

namespace lutlib {

struct BareShape {
    int size = 0; ///< nodes, and pixels from fold to fold
    PictureSize picture;
    friend bool operator==(const BareShape&, const BareShape&) = default;
};

/// A rectangle of that shape.
struct BarePlace {
    BareShape shape;
    bool quarter = false; ///< in the picture turned by one quarter clockwise
    Pixel at;
    double roughness = 1; ///< as recognise.h has it
};

/// Whether two places share pixels of the picture, which has that size unturned.
bool overlap(const BarePlace& a, const BarePlace& b, PictureSize whole);

Picture cut(const Picture& picture, Pixel at, PictureSize size);

/// The squared steps from each pixel's left neighbour to it, summed over rows from the top.
class ColumnSteps {
  public:
    explicit ColumnSteps(const Picture& picture);

    PictureSize size() const { return picture_; }
    /// Column by column, of the rows from `top` to before `bottom`.
    std::vector<double> of_rows(int top, int bottom) const;

  private:
    PictureSize picture_;
    std::vector<double> sums_;
};

/// Places of that shape without overlap, the smoothest first. `picture` is the one of `steps`,
/// turned by a quarter where that is said; `whole` is its size unturned.
std::vector<BarePlace> bare_places(const Picture& picture, const ColumnSteps& steps,
                                   const BareShape& shape, bool quarter, PictureSize whole);

} // namespace lutlib
