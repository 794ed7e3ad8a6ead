// Shared memory that is used again: new pages cost a fault each, which takes longer than to fill
// them.
#pragma once

#include "lutlib/io/sample_buffer.h"

#include <cstddef>
#include <memory>

namespace lutlib::io::box {

/// For the pictures of a sequence. Any threads may take from it at once.
class SharedPool {
  public:
    SharedPool();

    /// Bytes of any value, from an earlier buffer of this size whose owners are gone, or new. The
    /// buffer may outlive the pool. Throws Error where there is no memory.
    SampleBuffer take(std::size_t size) const;

  private:
    struct Kept;
    std::shared_ptr<Kept> kept_;
};

} // namespace lutlib::io::box
