// Input that happens faster than frames follow.
#include "preview/editor/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <gtest/gtest.h>

namespace preview::ui {
namespace {

using Kind = InputEvent::Kind;

InputEvent move(float x) {
    return {Kind::move, x, 0};
}
InputEvent button(bool down) {
    return {Kind::button, 0, 0, GLFW_MOUSE_BUTTON_LEFT, 0, 0, down};
}
InputEvent key(int code, bool down) {
    return {Kind::key, 0, 0, code, 0, 0, down};
}
InputEvent character(char c) {
    return {Kind::character, 0, 0, c};
}

/// How many events each frame sees.
std::vector<std::size_t> frames_of(const std::vector<InputEvent>& events) {
    InputQueue queue;
    for (const InputEvent& event : events)
        queue.push(event);
    std::vector<std::size_t> out;
    std::vector<InputEvent> seen;
    while (!queue.empty()) {
        const std::vector<InputEvent> frame = queue.next_frame();
        out.push_back(frame.size());
        seen.insert(seen.end(), frame.begin(), frame.end());
        if (frame.empty())
            break;
    }
    EXPECT_EQ(seen.size(), events.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
        EXPECT_EQ(seen[i].kind, events[i].kind) << i;
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
    EXPECT_EQ(frames_of({key(GLFW_KEY_L, true), character('l'), key(GLFW_KEY_L, false),
                         key(GLFW_KEY_O, true), character('o'), key(GLFW_KEY_O, false)}),
              (Frames{2, 3, 1}));
}

TEST(InputQueue, shows_a_shortcut_with_its_modifier_held) {
    EXPECT_EQ(frames_of({key(GLFW_KEY_LEFT_CONTROL, true), key(GLFW_KEY_Z, true),
                         key(GLFW_KEY_Z, false), key(GLFW_KEY_LEFT_CONTROL, false)}),
              (Frames{2, 2}));
}

TEST(InputQueue, keeps_a_deletion_before_the_character_typed_after_it) {
    EXPECT_EQ(frames_of({key(GLFW_KEY_BACKSPACE, true), key(GLFW_KEY_X, true), character('x')}),
              (Frames{1, 2}));
}

TEST(InputQueue, has_nothing_to_show_when_nothing_happened) {
    InputQueue queue;
    EXPECT_TRUE(queue.empty());
    EXPECT_TRUE(queue.next_frame().empty());
}

} // namespace
} // namespace preview::ui
