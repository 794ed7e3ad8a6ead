#include "lutlib/io/png_stream.h"

#include "lutlib/error.h"
#include "lutlib/io/png.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <string_view>

namespace lutlib::io {
namespace {

constexpr std::size_t signature_bytes = 8, chunk_head_bytes = 8, chunk_sum_bytes = 4;

} // namespace

// False where the source ends before the first of them.
bool PngStream::append(std::string& to, std::size_t bytes) {
    const std::size_t start = to.size();
    // A length that is a lie is not believed before its bytes are there.
    constexpr std::size_t at_once = std::size_t{1} << 20;
    for (std::size_t got = 0; got < bytes;) {
        to.resize(start + std::min(bytes, got + at_once));
        const std::size_t now = source_.read(to.data() + start + got, to.size() - start - got);
        if (now == 0) {
            to.resize(start + got);
            if (got == 0 && start == 0) {
                return false;
            }
            throw Error("picture " + std::to_string(count_ + 1) + " is cut short", {name_, 0, {}});
        }
        got += now;
    }
    return true;
}

std::optional<std::string> PngStream::next() {
    std::string out;
    if (!append(out, signature_bytes)) {
        return std::nullopt;
    }
    if (!is_png(out)) {
        throw Error("expected a PNG file after " + std::to_string(count_) +
                        " PNG files, found other bytes; send whole PNG files only",
                    {name_, 0, {}});
    }
    for (std::string_view chunk; chunk != "IEND";) {
        const std::size_t head = out.size();
        append(out, chunk_head_bytes);
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            length = length << 8 | static_cast<unsigned char>(out[head + i]);
        }
        if (out.size() + length + chunk_sum_bytes > limits::max_file_bytes) {
            throw Error("picture " + std::to_string(count_ + 1) + " is larger than the limit of " +
                            std::to_string(limits::max_file_bytes) + " bytes",
                        {name_, 0, {}});
        }
        append(out, length + chunk_sum_bytes);
        chunk = std::string_view(out).substr(head + 4, 4);
    }
    ++count_;
    return out;
}

} // namespace lutlib::io
