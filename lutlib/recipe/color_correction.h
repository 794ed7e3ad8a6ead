// A correction of an ASC Color Decision List (version 1.2) as numbers, and what of it an operator
// holds, or of an operator it.
#pragma once

#include "lutlib/format.h"
#include "lutlib/recipe/recipe.h"

#include <string>
#include <vector>

namespace lutlib {

struct ColorCorrection {
    std::string id{};          ///< unique in its file; may be empty
    std::string description{}; ///< for people
    RgbD slope{1, 1, 1}, offset{0, 0, 0}, power{1, 1, 1};
    double saturation = 1;
    friend bool operator==(const ColorCorrection&, const ColorCorrection&) = default;
};

/// As the operator "cdl", without its clamp. Numbers beyond the operator's ranges are brought into
/// them, and are losses.
Operation operation_of(const ColorCorrection& correction, std::vector<Loss>& losses);

/// The numbers of that operator "cdl" of the recipe. Losses are what else the look does, and what
/// readers may do otherwise. Without id and description.
ColorCorrection correction_of(const Recipe& recipe, std::size_t operation,
                              std::vector<Loss>& losses);

/// How far clamping to 0..1, as the standard has it and such files cannot say, moves a colour of
/// 0..1 at most.
double clamping_of(const ColorCorrection& correction);

} // namespace lutlib
