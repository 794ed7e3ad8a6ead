// Recognises the right texels in the wrong place.
#pragma once

#include "lutlib/verify/diagnose.h"

#include <optional>

namespace lutlib {

/// Where a picture was moved by up to eight columns and rows, or by a slice: how far, and the share
/// of the texels whose right place lies within the picture that are right so. Nothing where no such
/// move makes nearly all of those right.
std::optional<Diagnosis> shifted(const CodeImage& picture, const Engine& engine, int size,
                                 const Transform& look);

/// Where each slice of blue is one of the look, yet not all stand where they should: which do not,
/// and the share of the texels that are right in their slice's place.
std::optional<Diagnosis> slices_exchanged(const CodeImage& picture, const Engine& engine, int size,
                                          const Transform& look);

} // namespace lutlib
