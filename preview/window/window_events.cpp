#include "preview/window/window_events.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace preview {

namespace {

WindowEvents& of(GLFWwindow* window) {
    return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

} // namespace

WindowEvents::WindowEvents(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).resized = true; });
    using Kind = ui::InputEvent::Kind;
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).input.push({Kind::move, static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        // A drag goes on outside; its moves keep coming.
        if (entered == GLFW_FALSE && !ImGui::IsAnyMouseDown())
            of(w).input.push({Kind::move, ui::far_away, ui::far_away});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).input.push({Kind::wheel, static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        of(w).input.push({Kind::button, 0, 0, button, 0, 0, action == GLFW_PRESS});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
        of(w).input.push({Kind::key, 0, 0, key, scancode, modifiers, action != GLFW_RELEASE,
                          action == GLFW_REPEAT});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
        of(w).input.push({Kind::character, 0, 0, static_cast<int>(character)});
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        of(w).dropped.insert(of(w).dropped.end(), paths, paths + count);
    });
}

} // namespace preview
