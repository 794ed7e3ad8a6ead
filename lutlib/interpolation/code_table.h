// A 1D table over pictures of few codes: the answer to each code, looked up.
#pragma once

#include "lutlib/interpolation/picture_view.h"
#include "lutlib/lut.h"

#include <array>
#include <vector>

namespace lutlib {

/// The answer of each channel to every code of an element of up to 16 bits, halves among them,
/// rounded once.
class CodeTable {
  public:
    CodeTable(const Lut1D& curve, Element from, Element to);

    /// Pixels `first` to `end` of row `y`, colours alone.
    void apply(const ConstPictureView& in, const PictureView& out, std::size_t y, std::size_t first,
               std::size_t end) const;

  private:
    std::size_t out_bytes_;
    std::array<std::vector<std::byte>, 3> answers_;
};

} // namespace lutlib
