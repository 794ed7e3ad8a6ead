#include "preview/cli/sequence.h"

#include "lutlib/error.h"
#include "lutlib/io/frames.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <system_error>

namespace preview {

namespace {

constexpr int most_frames = 100000;

bool reads(const char* begin, const char* end, int& value) {
    const auto read = std::from_chars(begin, end, value);
    return read.ec == std::errc{} && read.ptr == end;
}

} // namespace

FramesAsked parse_frames(const std::string& text) {
    FramesAsked out;
    const char* const begin = text.data();
    const char* const end = begin + text.size();
    if (reads(begin, end, out.count) && out.count >= 1 && out.count <= most_frames) {
        return out;
    }
    const std::size_t dash = text.find('-');
    FrameRange range;
    if (dash != std::string::npos && reads(begin, begin + dash, range.first) &&
        reads(begin + dash + 1, end, range.last) && range.first >= 0 && range.first <= range.last &&
        range.last <= most_frames) {
        out.range = range;
        return out;
    }
    throw lutlib::UsageError(fmt::format("--frames needs a count of 1 to {0}, or FIRST-LAST within "
                                         "0 to {0}, got '{1}'",
                                         most_frames, text));
}

void refuse_hashes(const std::string& path) {
    if (path.find("##") != std::string::npos) {
        throw lutlib::UsageError(fmt::format("-o '{}': # stand for the number of a frame; name "
                                             "frames, as --frames 0-119, without --cube-view, or "
                                             "take the # out",
                                             path));
    }
}

bool is_frame_there(const std::string& path) {
    std::error_code failed;
    return std::filesystem::is_regular_file(path, failed) &&
           std::filesystem::file_size(path, failed) > 0 && !failed;
}

std::string frame_path(const std::string& pattern, int frame) {
    const auto place = lutlib::io::FramePattern::of(pattern, 1);
    if (!place) {
        throw lutlib::UsageError("--frames FIRST-LAST writes a file for each frame: put #### for "
                                 "its number into -o, as in frame.####.png");
    }
    return place->path_of(frame);
}

} // namespace preview
