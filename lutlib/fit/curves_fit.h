// Curves, a matrix and curves again, nearest to a look in the sense of least squares:
//
//   out_c = after_c( sum_k M_ck before_k(in_k) )
//
// By turns, each a linear problem: the curves `after` by the results of the rest; then the matrix
// and the curves `before` by the inputs at which `after` has the look's results, weighed by its
// slope. Of looks that are of this form it finds one within what its entries can hold; of others it
// says nothing about the nearest.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/engine/inline_look.h"
#include "lutlib/transform.h"

#include <vector>

namespace lutlib {

/// What was found on the way from each of two beginnings: curves that do nothing, and those of the
/// encodings, which are sRGB's where they are not known. The one that errs least over the fit's own
/// samples first.
std::vector<InlineCurves> fit_curves(const Transform& look, const Domain& domain,
                                     const LookEncodings& encodings, int entries);

/// Of a look whose channels do not mix: its own results at each entry.
InlineCurves sampled_curves(const Transform& look, const Domain& domain, int entries);
/// Whether they do not, over a few hundred colours of the domain.
bool keeps_channels_apart(const Transform& look, const Domain& domain);

} // namespace lutlib
