// The scopes' counts on the CPU, exactly those of shaders/scope_*.comp.
#pragma once

#include "preview/finish/scopes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace preview::reference {

/// Of a picture of four 8-bit codes a texel, `width` texels wide. `columns` as scope_columns()
/// says.
std::vector<std::uint32_t> scope_counts(const Scope& scope, std::span<const std::uint8_t> rgba,
                                        std::uint32_t width, const ScopeArea& area,
                                        std::uint32_t columns);

/// The codes of other levels, as shaders/scope_codes.comp has them: through lutlib's own curves in
/// double. The fourth of a texel is 255.
std::vector<std::uint8_t> scope_codes(std::span<const std::uint8_t> rgba,
                                      const ScopeLevels& levels);

} // namespace preview::reference
