#include "preview/window/window_events.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <iterator>

namespace preview {

namespace {

WindowEvents& of(GLFWwindow* window) {
    return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

struct KeyName {
    int glfw;
    editor::Key key;
};
constexpr KeyName keys[] = {
    {GLFW_KEY_F1, editor::Key::f1},
    {GLFW_KEY_ESCAPE, editor::Key::escape},
    {GLFW_KEY_C, editor::Key::c},
    {GLFW_KEY_A, editor::Key::a},
    {GLFW_KEY_B, editor::Key::b},
    {GLFW_KEY_E, editor::Key::e},
    {GLFW_KEY_F, editor::Key::f},
    {GLFW_KEY_D, editor::Key::d},
    {GLFW_KEY_L, editor::Key::l},
    {GLFW_KEY_PAGE_UP, editor::Key::page_up},
    {GLFW_KEY_PAGE_DOWN, editor::Key::page_down},
    {GLFW_KEY_P, editor::Key::p},
    {GLFW_KEY_O, editor::Key::o},
    {GLFW_KEY_Q, editor::Key::q},
    {GLFW_KEY_R, editor::Key::r},
    {GLFW_KEY_S, editor::Key::s},
    {GLFW_KEY_V, editor::Key::v},
    {GLFW_KEY_Y, editor::Key::y},
    {GLFW_KEY_Z, editor::Key::z},
    {GLFW_KEY_1, editor::Key::digit_1},
    {GLFW_KEY_2, editor::Key::digit_2},
    {GLFW_KEY_3, editor::Key::digit_3},
    {GLFW_KEY_4, editor::Key::digit_4},
    {GLFW_KEY_5, editor::Key::digit_5},
    {GLFW_KEY_0, editor::Key::digit_0},
    {GLFW_KEY_EQUAL, editor::Key::plus},
    {GLFW_KEY_KP_ADD, editor::Key::plus},
    {GLFW_KEY_MINUS, editor::Key::minus},
    {GLFW_KEY_KP_SUBTRACT, editor::Key::minus},
    {GLFW_KEY_KP_0, editor::Key::digit_0},
    {GLFW_KEY_6, editor::Key::digit_6},
    {GLFW_KEY_7, editor::Key::digit_7},
    {GLFW_KEY_8, editor::Key::digit_8},
    {GLFW_KEY_9, editor::Key::digit_9},
    {GLFW_KEY_F2, editor::Key::f2},
    {GLFW_KEY_F3, editor::Key::f3},
    {GLFW_KEY_F4, editor::Key::f4},
    {GLFW_KEY_F5, editor::Key::f5},
    {GLFW_KEY_F6, editor::Key::f6},
    {GLFW_KEY_F7, editor::Key::f7},
};

constexpr std::size_t modifier_count = 4; // left, then right as many
constexpr int modifier_bits[modifier_count] = {GLFW_MOD_SHIFT, GLFW_MOD_CONTROL, GLFW_MOD_ALT,
                                               GLFW_MOD_SUPER};

bool is_modifier(int glfw) {
    return glfw >= GLFW_KEY_LEFT_SHIFT && glfw <= GLFW_KEY_RIGHT_SUPER;
}

} // namespace

editor::Key key_of(int glfw) {
    if (is_modifier(glfw)) {
        return editor::Key::modifier;
    }
    const auto* const row = std::find_if(std::begin(keys), std::end(keys),
                                         [&](const KeyName& it) { return it.glfw == glfw; });
    return row == std::end(keys) ? editor::Key::none : row->key;
}

editor::Modifiers WindowEvents::held() const {
    const auto is = [&](std::size_t i) { return held_[i] || held_[i + modifier_count]; };
    return {.ctrl = is(1), .shift = is(0), .alt = is(2), .super = is(3)};
}

void WindowEvents::push(editor::InputEvent event) {
    event.held = held();
    input.push(event);
}

void WindowEvents::hold(int key, bool down) {
    held_[static_cast<std::size_t>(key - GLFW_KEY_LEFT_SHIFT)] = down;
}

void WindowEvents::correct(int modifiers) {
    for (std::size_t i = 0; i < modifier_count; ++i) {
        const bool is = (modifiers & modifier_bits[i]) != 0;
        if (!is) {
            held_[i] = held_[i + modifier_count] = false;
        } else if (!held_[i] && !held_[i + modifier_count]) {
            held_[i] = true;
        }
    }
}

WindowEvents::WindowEvents(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).resized = true; });
    glfwSetWindowPosCallback(window, [](GLFWwindow* w, int, int) { of(w).moved = true; });
    // Whoever draws the next frame asks for the new one.
    glfwSetWindowContentScaleCallback(window,
                                      [](GLFWwindow* w, float, float) { of(w).resized = true; });
    using Kind = editor::InputEvent::Kind;
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).push({Kind::move, static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        // A drag goes on outside; its moves keep coming.
        if (entered == GLFW_FALSE && !ImGui::IsAnyMouseDown()) {
            of(w).push({Kind::move, editor::far_away, editor::far_away});
        }
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).push({Kind::wheel, static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
        of(w).correct(modifiers);
        of(w).push({Kind::button, 0, 0, button, 0, 0, action == GLFW_PRESS});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
        if (is_modifier(key)) {
            of(w).hold(key, action != GLFW_RELEASE);
        } else {
            of(w).correct(modifiers);
        }
        of(w).push({Kind::key, 0, 0, key, scancode, modifiers, action != GLFW_RELEASE,
                    action == GLFW_REPEAT, key_of(key)});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
        of(w).push({Kind::character, 0, 0, static_cast<int>(character)});
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        WindowEvents::Dropped& dropped = of(w).dropped;
        dropped.paths.insert(dropped.paths.end(), paths, paths + count);
        double x = 0, y = 0;
        glfwGetCursorPos(w, &x, &y);
        dropped.x = static_cast<float>(x);
        dropped.y = static_cast<float>(y);
    });
}

} // namespace preview
