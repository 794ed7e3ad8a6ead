// What `show` shows of looks. A panel is a file that ends in its row, and its line in panels.cpp;
// it computes figures, and neither draws nor prints.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/lut.h"
#include "lutlib/plot/figure.h"
#include "lutlib/transform.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace converter {

/// A look as panels see it.
struct ShownLook {
    std::string name; ///< told apart from the other's; no control characters
    lutlib::Transform look;
    lutlib::Domain domain;          ///< the inputs that it is meant for
    lutlib::Encoding input, output; ///< of its code values
};

/// One look or two.
using ShownLooks = std::span<const ShownLook>;

struct Panel {
    std::string_view name;
    std::string_view label; ///< in the words of the field
    std::string_view help;  ///< what is shown and how it is computed, a sentence or more
    /// The same axes for both looks. What has no value is not a finite one.
    std::vector<plot::Figure> (*figures)(ShownLooks looks);
};

/// Every panel, in the order in which they are shown.
std::span<const Panel* const> panels();

} // namespace converter
