// How a picture's 8-bit codes become the 8-bit codes of other levels, exactly: the storage block of
// shaders/scope_codes.comp.
//
// A curve in pieces, as looks are converted with, is within a millionth of a code, and so on the
// wrong side of some level's edge. Here light is a whole number of 64 bits: a sum of three entries,
// one for each channel's code, that is looked for among the lights at which the next level begins.
#pragma once

#include "preview/finish/scope_levels.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace preview {

struct ScopeCodeTables {
    static constexpr std::size_t codes = 256;
    using Wide = std::array<std::uint32_t, 2>; ///< a signed number, its low word first

    Wide darkest{}, brightest{};           ///< what light is held to
    std::array<Wide, 3 * 3 * codes> light; ///< of a channel, by each channel and its code
    std::array<Wide, codes> rises;         ///< light at which a level begins
};
ScopeCodeTables scope_code_tables(const ScopeLevels& levels);

} // namespace preview
