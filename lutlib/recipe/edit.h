// A recipe as a transform, evaluated exactly.
#pragma once

#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"

#include <vector>

namespace lutlib {

/// The recipe's base and operators, compiled. Colours are converted between code values, linear
/// light and Oklab only where neighbouring operators differ, so code values are decoded at most
/// once for a run of operators in light. Operations that are disabled or at their defaults cost
/// nothing and round nothing: a recipe of such is exactly the identity.
///
/// Every double has a finite answer: NaN reads as 0, and every stage's result is held within the
/// range of a float. Needs base_lut where the recipe names a base; throws Error otherwise.
class Edit {
  public:
    explicit Edit(const Recipe& recipe);

    void operator()(std::span<RgbD> colours) const;
    RgbD operator()(RgbD colour) const;

    /// What follows the base: operators and the output's encoding.
    void after_base(std::span<RgbD> colours) const;

  private:
    void convert(const Recipe& recipe, Space from, Space to);

    std::shared_ptr<const Lut> base_;
    std::vector<Transform> stages_;
};

} // namespace lutlib
