// How a picture gets into a box of another size. Plain: no GPU.
#pragma once

#include "preview/gpu/size.h"

#include <string>

namespace preview {

/// The largest size of the picture's proportions within the box, at least 1x1.
Size fitted(Size picture, Size box);

/// What becomes of a picture in the middle of such a box, as a sentence goes on; empty where
/// nothing does.
std::string fit_text(Size picture, Size box);

} // namespace preview
