// Tells the colour of one texel before the looks and after each side's.
#pragma once

#include "preview/finish/probe.h"
#include "preview/passes/finish.h"

namespace preview {

/// A buffer for probe_from(), after presenting it. The finishing pass's own inputs; both looks
/// count, whatever the comparison shows.
BufferHandle add_probe(Graph& graph, const Finishing& finishing, ProbePlace place);

} // namespace preview
