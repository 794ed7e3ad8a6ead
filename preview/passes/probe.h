// Tells the colour of one texel before the looks and after each side's.
#pragma once

#include "preview/finish/probe.h"
#include "preview/passes/finish.h"
#include "preview/passes/still.h"

namespace preview {

/// A buffer for probe_from(), after presenting it. The finishing pass's own inputs; both looks
/// count, whatever the comparison shows. A side with a still tells that.
BufferHandle add_probe(Graph& graph, const Finishing& finishing, ProbePlace place,
                       const std::array<StillSide, 2>& stills = {});

} // namespace preview
