// What the window hears between frames: mouse, keys, files dropped on it, a new size.
#pragma once

#include "preview/editor/input.h"

#include <string>
#include <vector>

struct GLFWwindow;

namespace preview {

/// What panels call a key of GLFW's.
editor::Key key_of(int glfw);

struct WindowEvents {
    /// Sets the window's callbacks and must outlive them.
    explicit WindowEvents(GLFWwindow* window);
    WindowEvents(const WindowEvents&) = delete;
    WindowEvents& operator=(const WindowEvents&) = delete;

    editor::InputQueue input;
    std::vector<std::string> dropped;
    bool resized = true; ///< also before the first frame
    bool moved = false;  ///< the window itself
};

} // namespace preview
