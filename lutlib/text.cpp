#include "lutlib/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace lutlib {
namespace {

// Whether the byte at `i` is the rest of a UTF-8 letter: up to two more lie before it and its
// first.
bool continues_a_letter(std::string_view text, std::size_t i) {
    for (std::size_t back = 1; back <= 3 && back <= i; ++back) {
        const auto byte = static_cast<unsigned char>(text[i - back]);
        if (byte < 0x80 || byte >= 0xC0) {
            const std::size_t length = byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
            return back < length;
        }
    }
    return false;
}

// Bytes of the blank that begins at `i`; 0 where none does. Word processors and web pages put
// no-break and typographic spaces (Unicode's Zs, zero-width marks, and the byte order mark) where a
// blank was meant; 0xA0 alone is the no-break space of one-byte character sets.
std::size_t blank_at(std::string_view text, std::size_t i) {
    const auto byte = [&](std::size_t k) {
        return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0U;
    };
    const unsigned first = byte(0), second = byte(1), third = byte(2);
    if (first == ' ' || first == '\t') {
        return 1;
    }
    if (first < 0x80) {
        return 0;
    }
    if (first == 0xC2 && second == 0xA0) {
        return 2;
    }
    if (first == 0xE2 && second == 0x80 && ((third >= 0x80 && third <= 0x8D) || third == 0xAF)) {
        return 3;
    }
    if ((first == 0xE3 && second == 0x80 && third == 0x80) ||
        (first == 0xEF && second == 0xBB && third == 0xBF)) {
        return 3;
    }
    return first == 0xA0 && !continues_a_letter(text, i) ? 1 : 0;
}

// Bytes of the blank that ends before `end`; 0 where none does.
std::size_t blank_before(std::string_view text, std::size_t end) {
    for (std::size_t length = 1; length <= std::min<std::size_t>(3, end); ++length) {
        if (blank_at(text.substr(0, end), end - length) == length) {
            return length;
        }
    }
    return 0;
}

void append_utf8(std::string& out, char32_t c) {
    const auto put = [&](char32_t byte) { out += static_cast<char>(byte); };
    if (c < 0x80) {
        put(c);
    } else if (c < 0x800) {
        put(0xC0 | c >> 6);
        put(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        put(0xE0 | c >> 12);
        put(0x80 | (c >> 6 & 0x3F));
        put(0x80 | (c & 0x3F));
    } else {
        put(0xF0 | c >> 18);
        put(0x80 | (c >> 12 & 0x3F));
        put(0x80 | (c >> 6 & 0x3F));
        put(0x80 | (c & 0x3F));
    }
}

enum class ByteOrder { none, little, big };

// By its mark, else by the NUL bytes beside two characters of ASCII.
ByteOrder utf16_order(std::string_view bytes) {
    if (bytes.size() < 4) {
        return ByteOrder::none;
    }
    if (bytes.starts_with("\xFF\xFE")) {
        return bytes[2] == 0 && bytes[3] == 0 ? ByteOrder::none : ByteOrder::little; // UTF-32
    }
    if (bytes.starts_with("\xFE\xFF")) {
        return ByteOrder::big;
    }
    const auto ascii = [](char c) {
        return c == '\t' || c == '\n' || c == '\r' || (c >= ' ' && c < 127);
    };
    if (ascii(bytes[0]) && bytes[1] == 0 && ascii(bytes[2]) && bytes[3] == 0) {
        return ByteOrder::little;
    }
    return bytes[0] == 0 && ascii(bytes[1]) && bytes[2] == 0 && ascii(bytes[3]) ? ByteOrder::big
                                                                                : ByteOrder::none;
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool spells_non_finite(std::string_view word) {
    if (!word.empty() && (word.front() == '+' || word.front() == '-')) {
        word.remove_prefix(1);
    }
    // Microsoft's C runtime writes 1.#INF, 1.#IND, 1.#QNAN.
    if (word.find('#') != std::string_view::npos) {
        return word.substr(0, 2) == "1.";
    }
    std::string text(word.substr(0, 16));
    std::transform(text.begin(), text.end(), text.begin(), lower);
    return text == "inf" || text == "infinity" || text == "nan" || text.substr(0, 4) == "nan(";
}

} // namespace

LineScanner::LineScanner(std::string_view bytes) : rest_(bytes) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.substr(0, 3) == byte_order_mark) {
        rest_.remove_prefix(3);
    }
}

LineScanner::LineScanner(std::string_view head, ByteSource& more) : LineScanner(head) {
    more_ = &more;
}

bool LineScanner::next(std::string_view& line) {
    std::size_t end = rest_.find_first_of("\r\n");
    // A CR at the end of what is there may be half of a CR LF.
    while (end == rest_.npos || end + 1 == rest_.size()) {
        const std::size_t searched = std::min(end, rest_.size());
        if (!fetch_more()) {
            break;
        }
        end = rest_.find_first_of("\r\n", searched);
    }
    if (rest_.empty()) {
        return false;
    }
    end = std::min(end, rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(end);
    if (!rest_.empty()) {
        rest_.remove_prefix(rest_.substr(0, 2) == "\r\n" ? 2 : 1);
    }
    ++line_;
    return true;
}

bool LineScanner::fetch(std::size_t least) {
    bool fetched = false;
    while (rest_.size() < least && fetch_more()) {
        fetched = true;
    }
    return fetched;
}

std::size_t LineScanner::remaining() const {
    return rest_.size() + (more_ ? more_->remaining() : 0);
}

// What has been walked over makes room; only a longer line makes the buffer grow.
bool LineScanner::fetch_more() {
    if (!more_) {
        return false;
    }
    constexpr std::size_t usual = std::size_t{64} << 10;
    if (buffer_.size() < 2 * rest_.size() || buffer_.empty()) {
        std::vector<char> larger(std::max(usual, 2 * rest_.size()));
        std::copy(rest_.begin(), rest_.end(), larger.begin());
        buffer_ = std::move(larger);
    } else {
        std::copy(rest_.begin(), rest_.end(), buffer_.begin());
    }
    const std::size_t held = rest_.size();
    const std::size_t got = more_->read(buffer_.data() + held, buffer_.size() - held);
    rest_ = {buffer_.data(), held + got};
    if (got == 0) {
        more_ = nullptr;
    }
    return got > 0;
}

void LineScanner::skip(std::size_t bytes, std::size_t lines) {
    rest_.remove_prefix(bytes);
    line_ += lines;
}

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string upper(std::string_view word) {
    std::string out(word);
    for (char& c : out) {
        c = upper(c);
    }
    return out;
}

std::string_view trimmed(std::string_view text) {
    std::size_t first = 0, end = text.size();
    while (const std::size_t length = first < end ? blank_at(text.substr(0, end), first) : 0) {
        first += length;
    }
    while (const std::size_t length = end > first ? blank_before(text, end) : 0) {
        end -= length;
    }
    return text.substr(first, end - std::min(first, end));
}

Words words_of(std::string_view line) {
    Words out;
    for (std::size_t i = 0; i < line.size();) {
        while (const std::size_t length = i < line.size() ? blank_at(line, i) : 0) {
            i += length;
        }
        const std::size_t start = i;
        while (i < line.size() && blank_at(line, i) == 0) {
            ++i;
        }
        if (i > start) {
            if (out.count < out.items.size()) {
                out.items[out.count] = line.substr(start, i - start);
            }
            ++out.count;
        }
    }
    return out;
}

std::optional<std::string> utf8_of_utf16(std::string_view bytes) {
    const ByteOrder order = utf16_order(bytes);
    if (order == ByteOrder::none) {
        return std::nullopt;
    }
    const auto unit = [&](std::size_t i) -> char32_t {
        const char32_t a = static_cast<unsigned char>(bytes[2 * i]);
        const char32_t b = static_cast<unsigned char>(bytes[2 * i + 1]);
        return order == ByteOrder::little ? (a | b << 8U) : (a << 8U | b);
    };
    constexpr char32_t mark = 0xFEFF, replacement = 0xFFFD;
    const std::size_t units = bytes.size() / 2;
    std::string out;
    out.reserve(units);
    for (std::size_t i = unit(0) == mark ? 1 : 0; i < units; ++i) {
        char32_t c = unit(i);
        const bool high = c >= 0xD800 && c < 0xDC00;
        const bool pair = high && i + 1 < units && unit(i + 1) >= 0xDC00 && unit(i + 1) < 0xE000;
        if (pair) {
            c = 0x10000 + ((c - 0xD800) << 10) + (unit(++i) - 0xDC00);
        }
        append_utf8(out, c >= 0xD800 && c < 0xE000 ? replacement : c);
    }
    return out;
}

NumberStatus parse_float(std::string_view word, float& value) {
    std::string with_point;
    if (std::count(word.begin(), word.end(), ',') == 1 &&
        word.find('.') == std::string_view::npos) {
        with_point = word;
        with_point[with_point.find(',')] = '.';
        word = with_point;
    }
    const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    const std::string_view digits = has_plus ? word.substr(1) : word;
    const char* const end = digits.data() + digits.size();
    const auto [stop, status] = std::from_chars(digits.data(), end, value);
    if (spells_non_finite(word)) {
        return NumberStatus::not_finite;
    }
    if (stop != end || digits.empty() || status == std::errc::invalid_argument) {
        return NumberStatus::not_a_number;
    }
    if (status == std::errc::result_out_of_range) {
        // Too large or too small to tell by the status alone; a double tells which, and a double's
        // own overflow or underflow shows in the sign of the exponent.
        double wide = 0;
        const auto wide_status = std::from_chars(digits.data(), end, wide).ec;
        const std::size_t exponent = digits.find_first_of("eE");
        const bool tiny = wide_status == std::errc{} ? std::abs(wide) < 1
                                                     : exponent != std::string_view::npos &&
                                                           digits.substr(exponent + 1, 1) == "-";
        value = digits.front() == '-' ? -0.0F : 0.0F;
        return tiny ? NumberStatus::ok : NumberStatus::not_finite;
    }
    return std::isfinite(value) ? NumberStatus::ok : NumberStatus::not_finite;
}

} // namespace lutlib
