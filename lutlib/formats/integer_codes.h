// Tables whose numbers are integer codes: which depth they have, said by the file or guessed.
#pragma once

#include "lutlib/lut.h"

#include <optional>
#include <string>

namespace lutlib {

/// A table of codes, of any depth, holds white or what is near it; one of intensities stays below.
inline constexpr int least_largest_code = 128;

/// 2^bits - 1.
double largest_code(int bits);

/// The usual depth (8, 10, 12, 14 or 16 bits) that codes up to `largest` need; nullopt beyond.
std::optional<int> depth_of_codes(double largest);

/// Turns tables of a .cube whose values are all whole and reach beyond 127, as no table of
/// intensities does, into 0..1, with a note of the depth and its reason: Panasonic's .vlt, by its
/// first comment or its name, has 12 bits, other files the least depth that their codes need. An
/// input range from 0 to the largest code of a depth is codes too, and declares at least that
/// depth, also for values that are all small. Tables over any other input range are left alone
/// when they do not leave it, as theirs are no codes. Small whole numbers of which nothing is
/// declared are read as they are, and said.
void scale_integer_codes(Lut& lut);

} // namespace lutlib
