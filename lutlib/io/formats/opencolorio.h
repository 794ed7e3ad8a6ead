// The maker of rows for formats that OpenColorIO reads.
#pragma once

#include "lutlib/format.h"

namespace lutlib::formats {

/// The extension under which OpenColorIO knows a file: its own, unless that is not the format's.
std::string opencolorio_extension(const FileFormat& format, const std::string& file);

Reading read_with_opencolorio(const FileFormat& format, std::string_view bytes,
                              const std::string& file, const ReadOptions& options);
std::string write_with_opencolorio(const FileFormat& format, const Lut& lut,
                                   const WriteOptions& options);

/// The row as one that OpenColorIO's writer writes, where it names one and has no other.
constexpr FileFormat written_by_opencolorio(FileFormat row) {
    if (!row.write && !row.opencolorio_writer.empty()) {
        row.write = write_with_opencolorio;
    }
    return row;
}

/// The row as one that OpenColorIO reads, which takes no tiny number for one, and writes as above.
constexpr FileFormat read_by_opencolorio(FileFormat row) {
    row.read = read_with_opencolorio;
    row.opencolorio = true;
    row.holds.tiny = false;
    return written_by_opencolorio(row);
}

} // namespace lutlib::formats
