// Whole files in and out. `-` is standard input or standard output. Writing is atomic: a temporary
// file beside the target, flushed to the disk, then renamed over it; whatever happens, the target
// is the old file or the whole new one.
#pragma once

#include "lutlib/byte_source.h"
#include "lutlib/io/descriptor.h"
#include "lutlib/io/extension.h"
#include "lutlib/limits.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lutlib::io {

inline constexpr std::string_view standard_stream = "-";

/// Every byte of a file, or of standard input for `-`. Throws Error for a file that is missing,
/// unreadable, a directory, empty or longer than `max_bytes`, before that much is allocated.
std::string read_file(const std::string& path, std::size_t max_bytes = limits::max_file_bytes);

/// A file, or standard input for `-`, that is read piece by piece. Throws Error for one that is
/// missing, unreadable or a directory.
class FileInput final : public ByteSource {
  public:
    explicit FileInput(const std::string& path);

    /// For messages.
    const std::string& name() const { return name_; }
    std::size_t read(char* to, std::size_t most) override;
    std::size_t remaining() const override;

    /// The next bytes, fewer than `most` only at the end. Throws Error where there are none.
    std::string head(std::size_t most);
    /// Every byte that is left behind `head`, which has been read. Throws Error as read_file()
    /// does.
    std::string all_of(std::string head, std::size_t max_bytes = limits::max_file_bytes);

  private:
    std::string name_;
    Descriptor file_;
    std::size_t size_ = 0; ///< of a regular file, as it was opened; 0: not known
    std::size_t read_ = 0;
};

/// The first bytes of a regular file, for libraries that then read it from its path themselves.
/// Nothing of pipes and devices, whose bytes can be read but once. Throws Error as read_file()
/// does.
std::optional<std::string> head_of_regular_file(const std::string& path, std::size_t bytes);

/// Whether a device, a pipe or a socket is there: it has no old content to protect, and must not be
/// replaced by a file.
bool is_special(const std::string& path);

/// Replaces `path` by `bytes` at once, or writes them to standard output for `-`. A new file gets
/// the permissions of the umask, a replaced one keeps its own, a symbolic link stays a link.
/// Devices and pipes are written in place. Throws Error; the old file is then unchanged.
void write_file(const std::string& path, std::string_view bytes);

/// The same of several files of one run, all or none: none is replaced before all are written, and
/// where one cannot be replaced those before it are put back.
struct FileToWrite {
    std::string path;
    std::string_view bytes;
};
void write_files(std::span<const FileToWrite> files);

/// While it lives, reading `-` whole on this thread gives these bytes, and what is written to `-`
/// is kept here: for who takes pictures off standard input one by one.
class StandardStreamsInstead {
  public:
    explicit StandardStreamsInstead(std::string input);
    ~StandardStreamsInstead();
    StandardStreamsInstead(const StandardStreamsInstead&) = delete;
    StandardStreamsInstead& operator=(const StandardStreamsInstead&) = delete;

    std::string input;  ///< given away once
    std::string output; ///< what has been written
};

/// What messages call a path: itself, or "standard input" / "standard output" for `-`.
std::string input_name(const std::string& path);
std::string output_name(const std::string& path);

} // namespace lutlib::io
