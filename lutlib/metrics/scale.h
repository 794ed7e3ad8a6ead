// Two readings of one file that differ by a factor: one of them took its codes for another depth.
#pragma once

#include "lutlib/transform.h"

#include <optional>
#include <span>

namespace lutlib {

/// The factor by which `a`'s images of the inputs exceed `b`'s; nullopt where no one factor makes
/// them equal within a thousandth, or where they are equal as they are.
std::optional<double> scale_between(const Transform& a, const Transform& b,
                                    std::span<const Rgb> inputs);

} // namespace lutlib
