// A reference still: a picture that stands on a side of a comparison as it is, in place of the
// shown picture under that side's look.
#pragma once

#include "lutlib/color/encoding.h"
#include "preview/gpu/size.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace preview {

struct Still {
    std::string path;
    std::optional<lutlib::Encoding> said; ///< in place of what its file says or is guessed
    Size size;
    std::vector<float> rgba; ///< a display's codes within 0..1, rows from the top
    /// How its colours are shown, a sentence; of a guess that it is one.
    std::string shown_as;
    std::vector<std::string> told; ///< what else was made of it
};

/// Integer codes are shown as they are, as those of the picture are; light is encoded by sRGB's
/// curve. With an encoding they are decoded by that and encoded as sRGB. Throws lutlib::Error for a
/// file that is no picture.
std::shared_ptr<const Still> load_still(const std::string& path,
                                        const std::optional<lutlib::Encoding>& said = {});

/// What people call it: the file's name without its ending.
std::string title_of(const Still& still);

} // namespace preview
