// Numbers of frames in the names of files: `shot.####.exr` and `shot.%04d.exr` as patterns of a
// sequence, `1001-1100x2` as the frames of one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib::io {

/// The largest number of a frame.
inline constexpr int last_frame = 999'999'999;

/// "7", "1001-1100", "1001-1100x2" (every second) and lists of them, "1-5,9", ascending and each
/// once. Throws UsageError for anything else, and for more than a million.
std::vector<int> parse_frames(std::string_view text);

/// The name of a file with a place for a frame's number.
class FramePattern {
  public:
    /// Nothing where the file's own name holds neither a run of at least `shortest_run` # nor `%d`
    /// or `%04d`. Of several the last one counts.
    static std::optional<FramePattern> of(std::string_view path, std::size_t shortest_run = 2);

    /// With zeros before a number of fewer digits than the place has.
    std::string path_of(int frame) const;
    /// The number in `path` as it is written there; nothing where it is no path_of() any frame.
    std::optional<std::string> frame_in(std::string_view path) const;

  private:
    std::string before_, after_;
    std::size_t digits_ = 1; ///< at least
};

} // namespace lutlib::io
