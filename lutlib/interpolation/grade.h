// A look over pictures where they lie: many pixels at once with the widest vectors that the
// processor has (Highway picks the code at run time), rows shared out over the cores (oneTBB).
//
// Outside the domain every channel is clamped, as evaluate() does: -Inf reads as the minimum, +Inf
// as the maximum, and NaN as the minimum. Integer results are clamped to 0..1 and rounded to
// nearest, halves held to +-65504 and rounded to nearest. The bytes do not depend on how many
// threads there are, nor on where a pixel lies.
#pragma once

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/interpolation/picture_view.h"

#include <memory>

namespace lutlib {

struct GradeTables;

/// A look laid out for pictures. Cheap to copy; may be used from several threads at once.
class Grading {
  public:
    /// The cube read as `how` says. Copies what it needs of the look.
    Grading(const Lut& lut, Interpolation how);
    explicit Grading(const Lut& lut) : Grading(lut, usual_interpolation(lut)) {}

    const GradeTables& tables() const { return *tables_; }

  private:
    std::shared_ptr<const GradeTables> tables_;
};

/// Grades `in` into `out`, which has its size: itself, or else nothing that overlaps it. Floats
/// come out within 2e-7 of evaluate_exact() (3e-7 of a 1D table and a cube), of values above 1
/// times the value, unless neighbouring nodes differ by more than 1; codes and halves are the
/// nearest to it or, in fewer than 0.5 % of samples, the next.
///
/// Alpha passes unchanged, between elements of two kinds to the nearest; `out`'s is left alone
/// where `in` has none. `threads`: 1 is the calling thread alone, 0 every core. Throws
/// std::invalid_argument for views of different sizes.
void grade(const Grading& look, const ConstPictureView& in, const PictureView& out,
           int threads = 0);

/// How many pixels have a colour outside the domain, NaN counted. On every core.
std::size_t pixels_outside(const Domain& domain, const ConstPictureView& in);
/// How many pixels have a NaN among their colours.
std::size_t pixels_with_nan(const ConstPictureView& in);

/// grade() from the definitions, a pixel at a time: evaluate_exact() in double, rounded once.
void grade_plainly(const Lut& lut, Interpolation how, const ConstPictureView& in,
                   const PictureView& out);

} // namespace lutlib
