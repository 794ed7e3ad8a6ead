// The finish that a built-in scene is made for.
#pragma once

#include "preview/finish/blooms.h"
#include "preview/finish/tonemaps.h"

#include <string_view>

namespace preview {

/// The finish that a scene of that name is made for; other inputs have the defaults.
struct UsualFinish {
    const Tonemap* tonemap;
    const Bloom* bloom;
    bool is_antialiased = true; ///< of a scene
};
UsualFinish usual_finish(std::string_view input);

} // namespace preview
