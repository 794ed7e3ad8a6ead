// The LUT formats that are read through OpenColorIO, as a table.
#pragma once

#include "lutlib/format.h"

#include <span>
#include <string>
#include <string_view>

namespace lutlib::io {

/// One format. It is read by OpenColorIO; `write`, or OpenColorIO's writer `ocio_writer`, writes
/// it. With neither it is only read. Formats that are only written have no `magic` and no read.
struct OcioFormat {
    std::string_view name;
    std::string_view label;
    std::span<const std::string_view> extensions; ///< lower case, first is default
    /// Text within the first bytes of every such file, and of no other format's; may be empty.
    std::string_view magic;
    bool readable = true;
    std::string_view ocio_writer;
    std::string (*write)(const Lut& lut, const WriteOptions& options) = nullptr;
    Holds holds;

    bool writable() const { return write != nullptr || !ocio_writer.empty(); }
};

std::span<const OcioFormat> ocio_formats();

} // namespace lutlib::io
