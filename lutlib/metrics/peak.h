// The largest error of all, nearly: a maximum over samples misses the peaks between them, so the
// worst of them are climbed.
#pragma once

#include "lutlib/lut.h"

#include <functional>
#include <vector>

namespace lutlib {

/// From the worst 32 of the colours, steps uphill that start at `step` (a share of the domain) and
/// shrink where they do not help. Returns the largest error met; the same on every machine.
/// `error_of` is called from several threads.
double peak_error(const std::vector<Rgb>& colours, const Domain& domain, float step,
                  const std::function<double(Rgb)>& error_of);

} // namespace lutlib
