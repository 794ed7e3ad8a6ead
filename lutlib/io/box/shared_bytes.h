// Memory that two processes see.
#pragma once

#include "lutlib/io/descriptor.h"

#include <cstddef>
#include <memory>
#include <span>

namespace lutlib::io::box {

class MappedFile;

/// A file without a name that this process fills and others may read. Copies share it.
class SharedBytes {
  public:
    SharedBytes() = default;
    /// Of zeros. Whoever has its descriptor may neither write nor shorten it, where the system can
    /// forbid that. Throws Error where there is no memory.
    explicit SharedBytes(std::size_t size);

    std::span<std::byte> bytes() const;
    /// -1 of none.
    int descriptor() const;

  private:
    std::shared_ptr<const MappedFile> file_;
};

/// What another process handed over, to read. It may still change, but not become shorter: what
/// must stay as it was checked is copied first.
class ForeignBytes {
  public:
    ForeignBytes() = default;
    /// Takes over a descriptor, with as many bytes as its file has now. Throws Error, for
    /// a file that may become shorter too.
    explicit ForeignBytes(int descriptor);

    std::span<const std::byte> bytes() const;
    /// -1 of none.
    int descriptor() const;

  private:
    std::shared_ptr<const MappedFile> file_;
};

/// An empty file without a name, for a library that writes to a path. Throws Error.
int new_memory_file();

} // namespace lutlib::io::box
