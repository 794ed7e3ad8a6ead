// The lighting pass in double, from the g-buffer, maps and blocks that it read in a frame.
#pragma once

#include "preview/check/pass_twins.h"

namespace preview {

/// Of a frame of any g-buffer. Surfaces that the forward path lights as it draws them have no
/// images to make a twin from.
Twin lighting_twin(const TwinInput& in);

} // namespace preview
