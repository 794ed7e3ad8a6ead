#include "lutlib/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace lutlib {
namespace {

bool blank(char c) {
    return c == ' ' || c == '\t';
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

bool LineScanner::next(std::string_view& line) {
    if (rest_.empty()) {
        return false;
    }
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(end);
    if (!rest_.empty()) {
        rest_.remove_prefix(rest_.substr(0, 2) == "\r\n" ? 2 : 1);
    }
    ++line_;
    return true;
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
    while (!text.empty() && blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

Words words_of(std::string_view line) {
    Words out;
    for (std::size_t i = 0; i < line.size();) {
        while (i < line.size() && blank(line[i])) {
            ++i;
        }
        const std::size_t start = i;
        while (i < line.size() && !blank(line[i])) {
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
