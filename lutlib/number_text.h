// Numbers as text, whatever the locale: the shortest decimals that read back as the same number,
// and shares in words.
#pragma once

#include "lutlib/rgb.h"

#include <span>
#include <string>

namespace lutlib {

std::string shortest(float value);
std::string shortest(double value);

/// "12 %", of a share from 0 to 1.
std::string percent(double share);

enum class Exponents {
    allowed, ///< wherever that is shorter
    rare,    ///< only below 1e-9 and from 1e9 on: some readers of LUT files know none
};

/// Appends to a long text, without a string of its own.
void append_number(std::string& out, float value, Exponents exponents);
/// "r g b" and a line end.
void append_row(std::string& out, const Rgb& row, Exponents exponents);
void append_rows(std::string& out, std::span<const Rgb> rows, Exponents exponents);

} // namespace lutlib
