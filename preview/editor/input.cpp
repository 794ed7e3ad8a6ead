#include "preview/editor/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace preview::ui {

namespace {

using Kind = InputEvent::Kind;

bool is_modifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

} // namespace

std::vector<InputEvent> InputQueue::next_frame() {
    std::vector<InputEvent> out;
    bool moved = false, is_full = false;
    while (!events_.empty()) {
        const InputEvent& event = events_.front();
        const bool belongs_to_key =
            event.kind == Kind::character && !out.empty() && out.back().kind != Kind::button;
        if (is_full && !belongs_to_key)
            break;
        if (event.kind == Kind::button && moved)
            break;
        moved = moved || event.kind == Kind::move;
        is_full =
            is_full || event.kind == Kind::button ||
            (event.kind == Kind::key && event.down && !event.repeats && !is_modifier(event.code));
        out.push_back(event);
        events_.pop_front();
    }
    return out;
}

} // namespace preview::ui
