// Every LUT file that the toolkit reads or writes, whatever reads or writes it: lutlib's own
// formats, OpenColorIO's, and pictures in every layout. The one place that programs ask.
#pragma once

#include "lutlib/format.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib::io {

/// Own formats first, then OpenColorIO's, then pictures. Standard output gets the first.
std::span<const FileFormat* const> file_formats();
/// The row named, or a UsageError that lists the names.
const FileFormat& require_file_format(std::string_view name);
/// What reads UTF-8 text or pixels that begin so; null for nothing known.
const FileFormat* find_format(std::string_view bytes, const std::string& file);
/// What reads these bytes: by content first, then by the extension of `file`. Throws Error.
const FileFormat& recognise_format(std::string_view bytes, const std::string& file);
/// What writes a file of this name: of the formats with its extension (the first format's, for
/// `-`) the first that can hold the look as it is, else the first that can hold its tables, else
/// the first. Throws UsageError.
const FileFormat& format_for_writing(const std::string& path, const Lut& lut);

/// Reads a LUT file, `-` from standard input. `format` empty: recognised. Throws Error, UsageError.
Reading read_lut(const std::string& path, const ReadOptions& options = {},
                 std::string_view format = {});
/// The same from memory; `file` names it in errors and lends its extension.
Reading decode_lut(std::string_view bytes, const std::string& file, const ReadOptions& options = {},
                   std::string_view format = {});

struct Encoded {
    std::string bytes;
    Lut lut; ///< the look as fitted to the format
    std::vector<Loss> losses;
    /// Which programs do not read this file, or read it otherwise, a sentence each.
    std::vector<std::string> readers;
};

/// The bytes of a file in this format. Throws Error, UsageError.
Encoded encode_lut(const Lut& lut, const FileFormat& format, const WriteOptions& options = {});
/// Encodes and writes atomically, `-` to standard output. `format` empty: format_for_writing().
Encoded write_lut(const std::string& path, const Lut& lut, const WriteOptions& options = {},
                  std::string_view format = {});

} // namespace lutlib::io
