// Memory that two processes see.
#pragma once

#include "lutlib/io/descriptor.h"
#include "lutlib/io/sample_buffer.h"

#include <cstddef>
#include <memory>
#include <span>

namespace lutlib::io::box {

/// Who may change bytes that one process has handed to another.
enum class Sharing {
    both,
    ended, ///< each only its own, from then on
};

/// A file without a name, mapped whole. Copies share it.
class SharedBytes {
  public:
    SharedBytes() = default;
    /// Of zeros. Throws Error where there is no memory.
    explicit SharedBytes(std::size_t size);
    /// Takes over a descriptor, with as many bytes as its file has now; whoever made the file may
    /// not shrink it any more where the system can forbid that. Where sharing is to be ended and
    /// somebody still has it mapped to write, the bytes are copied. Throws Error.
    static SharedBytes adopt(int descriptor, Sharing sharing = Sharing::both);

    std::span<std::byte> bytes() const;
    /// -1 of none.
    int descriptor() const;
    /// The same bytes as a picture's; with the descriptor only where sharing has not ended, as it
    /// would not hold what changes.
    SampleBuffer samples() const;

  private:
    struct Mapping;
    explicit SharedBytes(std::shared_ptr<Mapping> mapping) : mapping_(std::move(mapping)) {}

    std::shared_ptr<Mapping> mapping_;
};

/// An empty file without a name, for a library that writes to a path. Throws Error.
int new_memory_file();
/// Forbids everybody to make the file shorter: whoever maps it would else be killed.
void seal_size(int descriptor);

} // namespace lutlib::io::box
