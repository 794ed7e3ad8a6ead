#include "preview/editor/input.h"

#include <cmath>

namespace preview::editor {

namespace {

/// Pixels that a hand moves the mouse by while it turns the wheel.
constexpr float shaken = 8;

} // namespace

std::vector<InputEvent> InputQueue::next_frame() {
    using Kind = InputEvent::Kind;
    std::vector<InputEvent> out;
    bool moved = false, turned = false, is_full = false;
    while (!events_.empty()) {
        const InputEvent& event = events_.front();
        const bool belongs_to_key =
            event.kind == Kind::character && !out.empty() && out.back().kind != Kind::button;
        if (is_full && !belongs_to_key) {
            break;
        }
        if (event.kind == Kind::button && moved) {
            break;
        }
        if ((moved || turned) && event.held != out.back().held) {
            break;
        }
        if (event.kind == Kind::move) {
            if (turned && std::hypot(event.x - x_, event.y - y_) > shaken) {
                break;
            }
            if (!turned) {
                x_ = event.x;
                y_ = event.y;
            }
        }
        moved = moved || event.kind == Kind::move;
        turned = turned || event.kind == Kind::wheel;
        is_full =
            is_full || event.kind == Kind::button ||
            (event.kind == Kind::key && event.down && !event.repeats && event.key != Key::modifier);
        out.push_back(event);
        events_.pop_front();
    }
    return out;
}

} // namespace preview::editor
