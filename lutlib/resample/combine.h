// Several looks made one: one after the other, or mixed.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/resample/resample.h"

#include <vector>

namespace lutlib {

/// In the order given: the first look gets the input, the second what the first gives. Each clamps
/// what it gets to its own domain. The looks must outlive the transform.
Transform composition(const std::vector<const Lut*>& looks, const ResamplingMethod& method);

/// Whether the looks, resampled, composed or blended, make a 1D table: one of them is one, none
/// mixes channels, and `sampling` names no shaper, which would stand before a cube.
bool make_curve(const std::vector<const Lut*>& looks, const Sampling& sampling);

/// The composition as one look, on the first look's domain and 1D table unless `sampling` says
/// otherwise; its default size is the largest among the looks' cubes. Of 1D tables alone, while
/// `sampling` names no shaper, it is a 1D table of as many entries as curve_tolerance takes. Throws
/// Error.
Lut compose(const std::vector<const Lut*>& looks, const Sampling& sampling,
            const ResamplingMethod& method);

/// The share of the first look's domain, over even samples, whose colours leave the domain of a
/// later look on their way and are clamped there.
double clamped_share(const std::vector<const Lut*>& looks, const ResamplingMethod& method);

/// (1 - amount) a + amount b. Each look clamps the input to its own domain; amounts beyond 0..1
/// extrapolate. The looks must outlive the transform.
Transform mixture(const Lut& a, const Lut& b, double amount, const ResamplingMethod& method);

/// The mixture as one look: over the union of both domains, with the 1D table that both share, if
/// they do, unless `sampling` says otherwise. Its default size is the larger. Of 1D tables alone it
/// is one, as compose()'s is; a 1D table and a cube get the table, where it rises, before the new
/// cube, so that the table's own bend costs nothing. Throws Error.
Lut blend(const Lut& a, const Lut& b, double amount, const Sampling& sampling,
          const ResamplingMethod& method);

} // namespace lutlib
