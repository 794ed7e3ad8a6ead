// The keys that the panels know, by our own names: the window maps its library's to them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace preview::editor {

enum class Key : std::uint8_t {
    none,     ///< one that no panel knows
    modifier, ///< Shift, Control, Alt, Super
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    escape,
    page_up,
    page_down,
    a, // from here on what a text field takes for itself
    b,
    c,
    d,
    e,
    f,
    l,
    o,
    p,
    q,
    r,
    s,
    v,
    y,
    z,
    digit_1,
    digit_2,
    digit_3,
    digit_4,
    digit_5,
    digit_6,
    digit_7,
    digit_8,
    digit_9,
    digit_0,
    plus, ///< also where it is typed with Shift
    minus,
    count_, ///< not a key
};
inline constexpr std::size_t key_count = static_cast<std::size_t>(Key::count_);

/// What stands on the key; nothing of one that no panel knows.
constexpr std::string_view text_of(Key key) {
    constexpr std::string_view texts[key_count] = {
        "",  "",  "F1", "F2", "F3", "F4", "F5", "F6", "F7", "Esc", "Page Up", "Page Down", "A",
        "B", "C", "D",  "E",  "F",  "L",  "O",  "P",  "Q",  "R",   "S",       "V",         "Y",
        "Z", "1", "2",  "3",  "4",  "5",  "6",  "7",  "8",  "9",   "0",       "+",         "-",
    };
    return texts[static_cast<std::size_t>(key)];
}

/// Whether the key types a character.
constexpr bool is_printable(Key key) {
    return key >= Key::a;
}

} // namespace preview::editor
