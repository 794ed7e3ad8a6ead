#include "lutlib/io/condensed.h"

#include <algorithm>
#include <string_view>

namespace lutlib::io {
namespace {

constexpr std::size_t longest = 300;

std::string without_runs_of_blanks(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool is_blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!is_blank) {
            out += c;
        } else if (!out.empty() && out.back() != ' ') {
            out += ' ';
        }
    }
    if (out.ends_with(' ')) {
        out.pop_back();
    }
    return out;
}

/// Behind the last such words; all of it where there are none.
std::string_view behind(std::string_view text, std::string_view words) {
    const std::size_t at = text.rfind(words);
    return at == std::string_view::npos ? text : text.substr(at + words.size());
}

} // namespace

std::string condensed(std::string text, const std::string& path, const std::string& file) {
    for (const std::string_view lack : {"bad_alloc", "_M_default_append", "length_error",
                                        "basic_string::", "vector::", "bad_array_new_length"}) {
        if (text.find(lack) != std::string::npos) {
            return "it takes more memory than there is";
        }
    }
    for (std::size_t at = path.empty() ? std::string::npos : text.find(path);
         at != std::string::npos; at = text.find(path, at)) {
        text.replace(at, path.size(), file);
        at += file.size();
    }
    std::string out = without_runs_of_blanks(text);
    if (out.size() > longest) {
        std::size_t end = longest;
        while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xc0U) == 0x80U) {
            --end; // not within a character of UTF-8
        }
        out = out.substr(0, end) + "...";
    }
    return out;
}

std::string reason_of_opencolorio(const std::string& text) {
    constexpr std::string_view one = "gave the error:", several = "gave the errors:";
    std::string_view out = behind(behind(text, several), one);
    if (out.size() == text.size()) {
        const bool tried_all = text.find("All formats have been tried") != std::string::npos;
        return tried_all ? "none of its readers knows such a file" : text;
    }
    const std::string_view failed = "failed with:";
    if (out.find(failed) == out.rfind(failed)) {
        out = behind(behind(out, failed), "Error is:");
    }
    return std::string(out);
}

} // namespace lutlib::io
