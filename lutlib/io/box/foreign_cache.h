// Memory of another process that is handed over again and again.
#pragma once

#include "lutlib/io/box/shared_bytes.h"

#include <cstddef>
#include <vector>

namespace lutlib::io::box {

/// Keeps it mapped: each page of a new mapping costs a fault.
class ForeignCache {
  public:
    /// Takes over a descriptor, as ForeignBytes does. Throws Error.
    ForeignBytes adopt(int descriptor);

  private:
    std::vector<ForeignBytes> known_; ///< the one used last is the last
    std::size_t size_ = 0;            ///< of all, in bytes
};

} // namespace lutlib::io::box
