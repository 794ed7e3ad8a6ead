// Cameras to go back to: the scene's first, those of its file, and those that were kept.
#pragma once

#include "preview/scene/scene.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace preview::panels {

struct Ui;

struct CameraList {
    std::vector<NamedCamera> kept;     ///< of what is shown
    std::optional<NamedCamera> keep;   ///< for the program to keep; without a name it gets one
    std::string forget;                ///< for the program to keep no longer; empty: none
    std::string name;                  ///< typed for the next one
    std::function<void()> take_others; ///< takes in what other windows keep; null: there are none
    bool asks() const { return keep || !forget.empty(); }
    /// Before they are listed.
    void renew() const {
        if (take_others) {
            take_others();
        }
    }
};

/// The part of the panel Scene.
void camera_controls(Ui& ui);

} // namespace preview::panels
