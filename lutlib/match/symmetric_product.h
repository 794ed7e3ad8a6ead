// A symmetric matrix of few diagonals times a vector.
#pragma once

#include <cstddef>
#include <span>

namespace lutlib {

/// Entry k stands in row k and column k + offset, and by symmetry in row k + offset and column k.
struct Diagonal {
    const double* entries;
    std::ptrdiff_t offset; ///< above 0
};

/// out[k] = own[k] x[k] + sum over diagonals (d[k] x[k + offset] + d[k - offset] x[k - offset]) for
/// k in first..last - 1. Entries and x reach as far before and behind that as the offsets do.
void symmetric_product(const double* own, std::span<const Diagonal> diagonals, const double* x,
                       double* out, std::size_t first, std::size_t last);

} // namespace lutlib
