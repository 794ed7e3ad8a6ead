// What `lutpreview check` renders: a scene or picture with its settings, and the rows that push it
// to the ends of what may happen.
#pragma once

#include "preview/frame/shown.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace preview {

/// All that a frame is made from, but for GPU objects.
struct Situation {
    std::shared_ptr<const Shown> shown;
    FrameSettings settings;
    std::vector<PointLight> lights; ///< in place of the scene's
    Surroundings surroundings;      ///< likewise
    const GpuLook* look_a = nullptr;
    const GpuLook* look_b = nullptr;

    bool has_scene() const { return shown->scene.has_value(); }
    bool has_light() const { return !shown->display_encoded(); }
};

/// The same with every effect in use, everything forced and the result in floats: no pass that
/// could be drawn is left out, and no rounding to 8 bits hides anything.
Situation with_every_pass(Situation situation);

/// One row of extreme input: what it changes. Several may be set.
struct Extreme {
    std::string name;
    std::string help{};
    std::function<void(Situation&)> change{};
    std::function<void(Scene&)> change_scene{};
    std::function<void(ShownPicture&)> change_picture{};
    /// What it feeds is itself not finite, so that what comes before the HDR resolve may not be.
    bool is_not_finite = false;
};

/// The rows that mean something for this situation.
std::vector<Extreme> extremes(const Situation& situation);

/// The situation with the row's changes.
Situation changed(const Situation& situation, const Extreme& row);

/// A value of a scene or picture that `lutpreview check` moves by one part in a million.
struct Nudge {
    std::string name;
    std::string help{};
    /// Scales what is a size, shifts what is an angle (of a radian) or a position (of a metre).
    std::function<void(Situation&, double share)> change{};
    std::function<void(Scene&, double share)> change_scene{};
    bool moves_geometry = false; ///< on the screen
};
std::vector<Nudge> nudges(const Situation& situation);
Situation changed(const Situation& situation, const Nudge& row, double share);

} // namespace preview
