// OpenColorIO's own writers.
#pragma once

#include "lutlib/io/ocio/transform.h"

namespace lutlib::io {

/// The bytes of a file of OpenColorIO's format `ocio_name`. Formats of operators (CLF, CTF) get the
/// look as matrices, curve and cube; the others are baked, which evaluates the look over 0..1 at
/// the nodes of a cube of the look's size: give them looks without shaper and domain.
std::string write_with_ocio(const Lut& lut, const std::string& ocio_name,
                            const WriteOptions& options);

} // namespace lutlib::io
