// The slow, obviously right twin of the .cube reader's inner loop: std::from_chars, value by value.
#pragma once

#include "lutlib/rgb.h"

#include <charconv>
#include <string_view>
#include <vector>

namespace lutlib {

/// The rows of a well-formed file whose lines end with LF; lines that begin with a letter or "#"
/// are skipped.
inline std::vector<Rgb> plain_read_rows(std::string_view text) {
    std::vector<Rgb> out;
    out.reserve(text.size() / 27);
    const char* p = text.data();
    const char* const end = p + text.size();
    while (p < end) {
        if ((*p >= 'A' && *p <= 'Z') || *p == '#' || *p == '\n') {
            while (p < end && *p != '\n') {
                ++p;
            }
            ++p;
            continue;
        }
        Rgb row;
        for (std::size_t c = 0; c < 3; ++c) {
            while (p < end && (*p == ' ' || *p == '\t')) {
                ++p;
            }
            p = std::from_chars(p, end, row[c]).ptr;
        }
        while (p < end && *p != '\n') {
            ++p;
        }
        ++p;
        out.push_back(row);
    }
    return out;
}

} // namespace lutlib
