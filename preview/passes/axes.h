// Counts a picture's colours before its looks along the axes of the operators' curves.
#pragma once

#include "preview/finish/curve_counts.h"
#include "preview/passes/finish.h"

namespace preview {

/// axis_bins counts for each row of counted_axes. The finishing pass's own inputs; `encoding` says
/// what the operators take the picture's codes for.
BufferHandle add_axes(Graph& graph, const Finishing& finishing, const lutlib::Encoding& encoding);

} // namespace preview
