// For each wanted colour the input of a look that gives it, and how that came about.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/resample/invert_index.h"

#include <optional>

namespace lutlib {

/// How the inverse at one node came about.
struct InverseAnswer {
    RgbD input;
    bool missing = false;
    double distance = 0; ///< of a missing colour to the nearest output
    double spread = 0;   ///< between the inputs of a folded colour
    double moved = -1;   ///< of a flat colour, from itself to its input
};

enum class Fate { undoable, flat, folded };

class InverseSolver {
  public:
    /// A look with a cube. Must outlive this.
    explicit InverseSolver(const Lut& look);

    /// Where no input gives it, the one whose output lies nearest.
    InverseAnswer solve(RgbD wanted) const;

    /// Whether the look's output tells this input.
    Fate fate(RgbD input) const;

    /// Cells to look at for one colour.
    double work() const;

    bool is_flat(RgbD place) const;

    /// Whether the 1D table gives this input of the cube.
    bool reached(RgbD place) const;

    /// Between inputs of the look and of its cube.
    RgbD unshaped(RgbD place) const;
    RgbD shaped(RgbD input) const;

  private:
    Preimages found(RgbD wanted, RgbD near) const;
    InverseAnswer among(const Preimages& all, RgbD wanted) const;

    const Lut& lut_;
    OutputIndex index_;
    double width_ = 0;
    std::optional<Domain> shaped_; // what the 1D table gives
};

} // namespace lutlib
