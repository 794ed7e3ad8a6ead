// Input that happens faster than frames follow.
#include "preview/editor/input.h"

#include <gtest/gtest.h>

namespace preview::editor {
namespace {

using Kind = InputEvent::Kind;

InputEvent move(float x) {
    return {Kind::move, x, 0};
}
InputEvent button(bool down) {
    return {Kind::button, 0, 0, 0, 0, 0, down};
}
InputEvent key(Key which, bool down) {
    return {Kind::key, 0, 0, 0, 0, 0, down, false, which};
}
InputEvent character(char c) {
    return {Kind::character, 0, 0, c};
}

/// How many events each frame sees.
std::vector<std::size_t> frames_of(const std::vector<InputEvent>& events) {
    InputQueue queue;
    for (const InputEvent& event : events) {
        queue.push(event);
    }
    std::vector<std::size_t> out;
    std::vector<InputEvent> seen;
    while (!queue.empty()) {
        const std::vector<InputEvent> frame = queue.next_frame();
        out.push_back(frame.size());
        seen.insert(seen.end(), frame.begin(), frame.end());
        if (frame.empty()) {
            break;
        }
    }
    EXPECT_EQ(seen.size(), events.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        EXPECT_EQ(seen[i].kind, events[i].kind) << i;
    }
    return out;
}

using Frames = std::vector<std::size_t>;

TEST(InputQueue, shows_all_moves_at_once) {
    EXPECT_EQ(frames_of({move(1), move(2), move(3)}), Frames{3});
}

TEST(InputQueue, shows_a_drag_pressed_where_it_starts_and_released_where_it_ends) {
    EXPECT_EQ(frames_of({move(1), button(true), move(2), move(3), button(false), move(4)}),
              (Frames{1, 1, 2, 1, 1}));
}

TEST(InputQueue, shows_a_click_as_press_and_release) {
    EXPECT_EQ(frames_of({button(true), button(false), button(true), button(false)}),
              (Frames{1, 1, 1, 1}));
}

TEST(InputQueue, shows_a_key_with_its_characters_before_its_release) {
    EXPECT_EQ(frames_of({key(Key::a, true), character('l'), key(Key::a, false), key(Key::b, true),
                         character('o'), key(Key::b, false)}),
              (Frames{2, 3, 1}));
}

TEST(InputQueue, shows_a_shortcut_with_its_modifier_held) {
    EXPECT_EQ(frames_of({key(Key::modifier, true), key(Key::z, true), key(Key::z, false),
                         key(Key::modifier, false)}),
              (Frames{2, 2}));
}

TEST(InputQueue, keeps_a_deletion_before_the_character_typed_after_it) {
    EXPECT_EQ(frames_of({key(Key::none, true), key(Key::s, true), character('x')}), (Frames{1, 2}));
}

InputEvent with_ctrl(InputEvent event) {
    event.held.ctrl = true;
    return event;
}

InputEvent wheel() {
    return {Kind::wheel, 0, 1};
}

TEST(InputQueue, shows_the_wheel_under_the_modifiers_that_were_held_when_it_turned) {
    const InputEvent down = with_ctrl(key(Key::modifier, true)), up = key(Key::modifier, false);
    EXPECT_EQ(frames_of({move(1), down, with_ctrl(wheel()), with_ctrl(wheel()), up, wheel()}),
              (Frames{1, 3, 2}));
    EXPECT_EQ(frames_of({down, with_ctrl(wheel()), up, down, with_ctrl(wheel()), up}),
              (Frames{2, 3, 1}));
}

TEST(InputQueue, shows_the_wheel_where_the_mouse_was_when_it_turned_however_a_hand_shakes) {
    EXPECT_EQ(frames_of({move(1), wheel(), move(5), wheel(), move(300), wheel(), move(1)}),
              (Frames{4, 2, 1}));
    EXPECT_EQ(frames_of({wheel(), move(300)}), (Frames{1, 1}));
}

TEST(InputQueue, shows_a_drag_under_the_modifiers_that_were_held) {
    const InputEvent down = with_ctrl(key(Key::modifier, true)), up = key(Key::modifier, false);
    EXPECT_EQ(frames_of({down, with_ctrl(move(1)), with_ctrl(button(true)), with_ctrl(move(2)), up,
                         move(3)}),
              (Frames{2, 1, 1, 2}));
}

TEST(InputQueue, has_nothing_to_show_when_nothing_happened) {
    InputQueue queue;
    EXPECT_TRUE(queue.empty());
    EXPECT_TRUE(queue.next_frame().empty());
}

} // namespace
} // namespace preview::editor
