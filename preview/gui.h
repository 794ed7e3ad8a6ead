// Dear ImGui's context on a window: its input, style, font and remembered layout. No GPU; the
// overlay draws it.
#pragma once

#include <string>

struct GLFWwindow;

namespace preview {

class Gui {
  public:
    /// `layout_path`: where the layout is remembered; empty: nowhere. The window's callbacks must
    /// have been set before. A font file that is missing leaves a notice().
    Gui(GLFWwindow* window, std::string layout_path, const std::string& font_path);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    void begin_frame();
    /// What a person should know of the set-up; empty when all is well.
    const std::string& notice() const { return notice_; }

  private:
    std::string layout_path_, notice_;
};

/// Where the panels' layout is remembered, or empty.
std::string layout_path();

/// The panels' font.
extern const char* const font_path;

} // namespace preview
