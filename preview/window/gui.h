// Dear ImGui's context on a window: its input, style, font and remembered layout. No GPU; the
// overlay draws it.
#pragma once

#include "preview/editor/input.h"

#include <array>
#include <string>
#include <vector>

struct GLFWwindow;

namespace preview {

class Gui {
  public:
    /// `layout_path`: where the layout is remembered; empty: nowhere. A font file that is missing
    /// or no font leaves a notice(). There is no text before set_scale().
    Gui(GLFWwindow* window, std::string layout_path, const std::string& font_path);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Text and what stands around it, so many times as large as at 96 dpi. Between frames; the
    /// overlay is made anew then.
    void set_scale(float scale);
    float scale() const { return scale_; }
    /// With what happened since the last one.
    void begin_frame(const std::vector<editor::InputEvent>& events);
    /// What a person should know of the set-up; empty when all is well.
    const std::string& notice() const { return notice_; }

  private:
    void feed(const editor::InputEvent& event);

    GLFWwindow* window_;
    float mouse_x_ = editor::far_away,
          mouse_y_ = editor::far_away; ///< beyond the window when the mouse is
    std::array<bool, 5> buttons_{};
    editor::Modifiers held_; ///< when the newest event happened
    std::string layout_path_, font_path_, notice_;
    float scale_ = 0;
};

/// Where the panels' layout is remembered. Empty when there is no settings_folder().
std::string layout_path();

} // namespace preview
