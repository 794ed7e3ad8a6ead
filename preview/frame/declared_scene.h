// What of a scene reaches a frame: its lights and casters, what the view sees, and all of it in the
// form that the passes read.
#pragma once

#include "preview/frame/settings.h"
#include "preview/passes/shadow.h"
#include "preview/passes/surroundings.h"
#include "preview/scene/scene_data.h"

#include <vector>

namespace preview {

struct DeclaredScene {
    SceneHandles handles;
    SurroundingsHandles surroundings;
    ShadowMaps shadows;
    bool takes_light = true;           ///< some surface does; else no light has reached the frame
    std::vector<Draw> opaque, blended; ///< of what is visible; the farthest of the blended first
};

/// Of inputs.scene as settings.orbit sees it in a picture of `size`; says what it leaves out.
DeclaredScene declare_scene(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                            Size size);

} // namespace preview
