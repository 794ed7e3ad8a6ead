// Bytes that arrive in pieces, so that a long text is never held whole.
#pragma once

#include <cstddef>

namespace lutlib {

class ByteSource {
  public:
    virtual ~ByteSource() = default;
    /// Some of the next bytes, at most `most`; 0 only at the end. Throws Error.
    virtual std::size_t read(char* to, std::size_t most) = 0;
    /// How many bytes are left, as far as the source can tell; 0 where it cannot.
    virtual std::size_t remaining() const = 0;
};

} // namespace lutlib
