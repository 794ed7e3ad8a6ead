// Which frames a sequence has, and their files.
#pragma once

#include <optional>
#include <string>

namespace preview {

/// Both are included.
struct FrameRange {
    int first = 0, last = 0;
};

/// What --frames says: a count for --timings, or a range for a sequence of files.
struct FramesAsked {
    int count = 0;
    std::optional<FrameRange> range;
};

/// "50", or "0-119". Throws lutlib::UsageError.
FramesAsked parse_frames(const std::string& text);

/// Throws lutlib::UsageError for a run of # in a file's name, which no sequence fills.
void refuse_hashes(const std::string& path);

/// Whether a frame's file is there: a file that is not empty, as they are written whole or not at
/// all.
bool is_frame_there(const std::string& path);

/// The file of a frame: its number in place of the last run of # (or %04d) of the file's own name,
/// with zeros before it. Throws lutlib::UsageError for a pattern without one.
std::string frame_path(const std::string& pattern, int frame);

} // namespace preview
