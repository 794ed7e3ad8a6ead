// What a window remembers until it is opened again, in a file beside its other settings.
#pragma once

#include "preview/window/window_place.h"

#include <optional>
#include <string>
#include <vector>

namespace preview {

struct WindowMemory {
    std::optional<DesktopArea> area; ///< of what it draws, while it is not maximised
    bool is_maximised = false;
    float text_scale = 1;              ///< times the desktop's
    float panels_width = 0;            ///< in heights of the text; 0: nobody has chosen one
    std::vector<std::string> recent{}; ///< files opened or saved last, the newest first
    bool has_strip = false;            ///< the looks of a folder are seen under the picture
    std::string strip_folder{};        ///< that somebody has chosen for them; empty: the look's own
    friend bool operator==(const WindowMemory&, const WindowMemory&) = default;
};

/// The ranges of its numbers, to which whoever changes them keeps.
inline constexpr float least_text_scale = 0.5F, most_text_scale = 4;
inline constexpr float most_panels_width = 400;

/// As memory_from() reads it.
std::string text_of(const WindowMemory& memory);
/// Of a file's text; numbers beyond their range are brought into it, what is missing is as usual.
/// Throws lutlib::Error when it is no such text.
WindowMemory memory_from(const std::string& text);

/// The memory in its file.
class MemoryFile {
  public:
    /// Empty: nothing is remembered. Where there is no file, and where it cannot be read (then with
    /// a notice()), the memory is as usual.
    explicit MemoryFile(std::string path);

    const WindowMemory& memory() const { return memory_; }
    /// What a person should know of the file; empty when all is well.
    const std::string& notice() const { return notice_; }
    /// Writes it when it is another. Throws lutlib::Error where that fails, and tries no more.
    void keep(const WindowMemory& memory);

  private:
    std::string path_, notice_;
    bool is_broken_ = false; ///< what is there is no memory
    WindowMemory memory_;
};

/// Where it is kept. Empty when there is no settings_folder().
std::string memory_path();

} // namespace preview
