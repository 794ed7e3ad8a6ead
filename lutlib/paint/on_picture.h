// Whether a look is what was done to a picture: the picture before, through the look, against the
// picture after.
#pragma once

#include "lutlib/metrics/stats.h"
#include "lutlib/metrics/viewing.h"
#include "lutlib/paint/strip.h"
#include "lutlib/transform.h"

#include <string>
#include <vector>

namespace lutlib {

struct OnPicture {
    ErrorStats delta_e_2000; ///< of the pixels outside the excepted area
    PictureSize size;        ///< that of the picture before
    std::vector<float> map;  ///< dE2000 of each pixel; below 0 where it was left out
    /// Edits that the look does not hold, a sentence each: parts of the picture, shading towards
    /// its corners, sharpening or blurring.
    std::vector<std::string> edits;
    std::vector<Area> parts; ///< squares of the picture that were edited by themselves
};

/// `after` may be larger than `before`, to the right and below, by what was placed beside it.
/// Pixels in `except`, of `after`, are left out, as are those with a channel that is not finite in
/// one of the pictures. Throws Error where none is left.
OnPicture on_picture(const Picture& before, const Picture& after, const Area& except,
                     const Transform& look, const Viewing& viewing = {});

} // namespace lutlib
