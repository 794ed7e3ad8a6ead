// What the user's own OpenColorIO configs convert.
#pragma once

#include "lutlib/io/ocio/transform.h"

namespace lutlib::io {

/// The config's conversion, not yet optimised. Throws Error for what the config or this OpenColorIO
/// does not know, naming what there is.
OCIO::ConstProcessorRcPtr processor_of_config(const ConfigConversion& conversion);

} // namespace lutlib::io
