// The HDR resolve in double: twin of shaders/resolve.comp.
#pragma once

#include "preview/reference/image.h"

namespace preview::reference {

/// Light times `exposure`, held within 0..65504 with NaN as 0; of another size filtered by the area
/// of each pixel, in its own proportions between black bars. `inner` is the picture's place in the
/// result, which is as large as `out`.
struct ResolvePlace {
    int x = 0, y = 0, width = 0, height = 0;
};
Image resolved(const Image& light, double exposure, int width, int height,
               const ResolvePlace& inner);

} // namespace preview::reference
