// What the window hears between frames: mouse, keys, files dropped on it, a new size.
#pragma once

#include "preview/editor/input.h"

#include <array>
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
    /// Files, and where the mouse let go of them.
    struct Dropped {
        std::vector<std::string> paths;
        float x = 0, y = 0;
    };
    Dropped dropped;
    /// Pushes with the modifiers that are held.
    void push(editor::InputEvent event);
    /// A modifier's key went down or up.
    void hold(int key, bool down);
    /// What the window system says of them beside an event: a key may have gone down in another
    /// window.
    void correct(int modifiers);
    bool resized = true; ///< also before the first frame
    bool moved = false;  ///< the window itself

  private:
    editor::Modifiers held() const;
    std::array<bool, 8> held_{}; ///< left and right: Shift, Control, Alt, Super
};

} // namespace preview
