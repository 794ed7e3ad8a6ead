// Mouse and keys on their way from the window to the panels, in the order in which they happened.
//
// Dear ImGui looks at the mouse and the keys once a frame. What happens faster than frames follow
// would be lost, or seen where the mouse went later, or under keys that were held before or after
// it, so a frame gets no more than it can tell apart.
#pragma once

#include "preview/editor/keys.h"

#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

namespace preview::editor {

/// Where the mouse is while it is not in the window, as Dear ImGui has it.
inline constexpr float far_away = -std::numeric_limits<float>::max();

/// Keys that are held beside others.
struct Modifiers {
    bool ctrl = false, shift = false, alt = false, super = false;
    friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

struct InputEvent {
    enum class Kind : std::uint8_t { move, wheel, button, key, character };
    Kind kind = Kind::move;
    float x = 0, y = 0; ///< where the mouse is, in the window's pixels; how far the wheel turned
    int code = 0;       ///< the window library's button or key, or the character
    int scancode = 0, modifiers = 0; ///< of keys, as the window library has them
    bool down = false;               ///< of buttons and keys: pressed (or repeated), not released
    bool repeats = false;
    Key key = Key::none; ///< of keys
    Modifiers held{};    ///< when it happened; of a modifier's own key, from then on
};

class InputQueue {
  public:
    void push(const InputEvent& event) { events_.push_back(event); }
    bool empty() const { return events_.empty(); }

    /// What the next frame sees, oldest first. Nothing follows a button's change in a frame, or the
    /// press of a key but its characters; a button changes in a later frame than the mouse came
    /// there, for a panel must know what is under the mouse. While the mouse moves or the wheel
    /// turns in a frame, the modifiers stay, and where the wheel turns the mouse stays but for the
    /// shaking of a hand. Empty only when nothing is left.
    std::vector<InputEvent> next_frame();

  private:
    std::deque<InputEvent> events_;
    float x_ = far_away, y_ = far_away; ///< where the mouse last came before a wheel turned
};

} // namespace preview::editor
