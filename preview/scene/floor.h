// A floor for models that come without.
#pragma once

#include "preview/scene/scene.h"

namespace preview {

/// Whether faces that look up lie under at least half of the scene's ground, within a twentieth of
/// its height from its lowest point, and reach beyond what stands on them: the bottom of a box is
/// no floor.
bool has_floor(const Scene& scene);

/// Puts a round grey stage under the scene, on which it throws shadows, and notes it in
/// scene.floor. It throws none itself.
void add_floor(Scene& scene);

} // namespace preview
