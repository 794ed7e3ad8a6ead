// Every LUT file that the toolkit reads or writes, whatever reads or writes it: lutlib's own
// formats, OpenColorIO's, and pictures in every layout. The one place that programs ask.
#pragma once

#include "lutlib/engine/layout.h"
#include "lutlib/format.h"
#include "lutlib/io/ocio.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib::io {

struct SaveOptions {
    std::string title; ///< replaces the look's own when not empty
    int size = 0;      ///< nodes per side of the cube; 0: as fit_to() chooses
    int bits = 16;     ///< of pictures: 8 or 16
};

/// One row: a format of any origin. Unset functions: the format is write-only or read-only.
struct FileFormat {
    std::string name; ///< as in --format
    std::string label;
    std::vector<std::string> extensions; ///< lower case, without the dot, first is default
    Holds holds;
    /// How surely these bytes are of this format, 0 .. 100; 0 where only the extension can say.
    std::function<int(std::string_view bytes)> sniff;
    std::function<Reading(std::string_view bytes, const std::string& file, const ReadOptions&)>
        read;
    /// Expects a look that fit_to(holds) returned.
    std::function<std::string(const Lut& lut, const SaveOptions& options)> write;
    const Layout* picture = nullptr; ///< of rows that are pictures in one layout
};

/// Own formats first, then OpenColorIO's, then pictures.
const std::vector<FileFormat>& file_formats();
/// Null when no format has this name.
const FileFormat* file_format_named(std::string_view name);
/// The row named, or a UsageError that lists the names.
const FileFormat& require_file_format(std::string_view name);
/// What reads these bytes: by content first, then by the extension of `file`. Throws Error.
const FileFormat& recognise_format(std::string_view bytes, const std::string& file);
/// What writes a file of this name: of the formats with its extension the first that can hold the
/// look as it is, else the first. `-` is a .cube. Throws UsageError.
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
};

/// The bytes of a file in this format. Throws Error, UsageError.
Encoded encode_lut(const Lut& lut, const FileFormat& format, const SaveOptions& options = {});
/// Encodes and writes atomically, `-` to standard output. `format` empty: format_for_writing().
Encoded write_lut(const std::string& path, const Lut& lut, const SaveOptions& options = {},
                  std::string_view format = {});

} // namespace lutlib::io
