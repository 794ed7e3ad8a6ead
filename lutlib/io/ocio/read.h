// From OpenColorIO's chain of operators to a look: exactly, or by sampling.
#pragma once

#include "lutlib/io/ocio/transform.h"

namespace lutlib::io {

/// The look of a processor. Affine maps and clamps before a curve or a cube become its domain,
/// affine maps after the last table are folded into its values. Everything else is sampled: the
/// part before the first operator that does not fit stays a shaper, the rest becomes a cube (a
/// curve when no channels mix). Losses carry the errors measured against OpenColorIO.
Reading look_of_processor(const OCIO::ConstProcessorRcPtr& processor, const ReadOptions& options);

} // namespace lutlib::io
