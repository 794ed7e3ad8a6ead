// The keys that the panels know, by our own names: the window maps its library's to them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace preview::editor {

enum class Key : std::uint8_t {
    none,     ///< one that no panel knows
    modifier, ///< Shift, Control, Alt, Super
    f1,
    escape,
    a, // from here on what a text field takes for itself
    b,
    e,
    q,
    r,
    s,
    y,
    z,
    digit_1,
    digit_2,
    digit_3,
    digit_4,
    digit_5,
};
inline constexpr std::size_t key_count = 17;

/// Whether the key types a character.
constexpr bool is_printable(Key key) {
    return key >= Key::a;
}

} // namespace preview::editor
