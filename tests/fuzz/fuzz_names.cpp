// Any text as what a command line says of many files: frames, a pattern of their names, a template
// of the new ones.
#include "lutlib/error.h"
#include "lutlib/io/frames.h"
#include "lutlib/io/output_names.h"
#include "lutlib/io/terminal.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace io = lutlib::io;

namespace {

void hold(bool is_true) {
    if (!is_true) {
        std::abort();
    }
}

void frames(std::string_view text) {
    try {
        const std::vector<int> found = io::parse_frames(text);
        hold(!found.empty() && found.size() <= 1'000'000 && found.front() >= 0 &&
             found.back() <= io::last_frame);
        hold(std::adjacent_find(found.begin(), found.end(), std::greater_equal<>()) == found.end());
    } catch (const lutlib::Error&) {
    }
}

void pattern(std::string_view text) {
    for (const std::size_t shortest : {1U, 2U}) {
        if (const auto found = io::FramePattern::of(text, shortest)) {
            const std::string path = found->path_of(1042);
            const auto frame = found->frame_in(path);
            hold(frame && frame->ends_with("1042"));
        }
    }
}

void output(const std::string& text) {
    try {
        io::OutputTemplate(text).path_for({"in/shot.1001.exr", "1001"});
    } catch (const lutlib::Error&) {
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (size > 4096) { // no path is longer
        return 0;
    }
    frames(text);
    pattern(text);
    output(std::string(text));
    const std::string shown = io::shown_text(text);
    hold(io::is_utf8(shown));
    hold(std::none_of(shown.begin(), shown.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
    return 0;
}
