// Which well-known mistake makes a LUT picture differ from what it should be.
#pragma once

#include "lutlib/engine/bake.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lutlib {

/// A look by an implementation that is not ours: transforms colours in place.
using Oracle = std::function<void(std::vector<Rgb>&)>;

/// A look that a picture may have been made from by mistake, such as another interpolation.
struct Alternative {
    std::string words;
    Oracle oracle;
};

/// Opened only when a picture is wrong; may be empty.
using Alternatives = std::function<std::vector<Alternative>()>;

/// A mistake that explains a picture: in words, and the share of texels that agree with the look
/// once the mistake is assumed.
struct Diagnosis {
    std::string words;
    double explained = 0;
};

/// Tries every row of a table of mistakes (what would the codes be, had somebody made it?) and
/// every alternative. The one that explains most texels is the diagnosis if it explains nearly all
/// of them; else the noise of a lossy format is recognised by its size and lack of a bias.
std::optional<Diagnosis> diagnose(const CodePicture& picture, const Engine& engine, int size,
                                  const Oracle& oracle, const Alternatives& alternatives);

/// Whether `code` is `value` (0..1) rounded to nearest, either way when the value lies within an
/// oracle's float precision of a tie.
bool is_rounded(int code, double value, int maximum);

} // namespace lutlib
