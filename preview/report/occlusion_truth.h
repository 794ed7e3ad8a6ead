// Ambient occlusion in double, and the frame that has it in place of the pass's.
#pragma once

#include "preview/report/study.h"

namespace preview::report {

/// What is left of the surroundings' light at every pixel by itself, in double, from the depths and
/// normals of the frame: neither halved nor blurred, from 1024 directions (256 of pictures of more
/// than 100,000 pixels). The finished picture is that of the frame whose lighting reads it.
Truth occlusion_truth(const TruthRequest& request);

} // namespace preview::report
