#include "lutlib/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace lutlib {
namespace {

template <class T>
std::string shortest_of(T value) {
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

} // namespace

std::string shortest(float value) {
    return shortest_of(value);
}

std::string shortest(double value) {
    return shortest_of(value);
}

std::string percent(double share) {
    return std::to_string(std::lround(100 * share)) + " %";
}

void append_number(std::string& out, float value, Exponents exponents) {
    std::array<char, 64> text;
    char* const begin = text.data();
    char* const end = begin + text.size();
    const float magnitude = std::abs(value);
    const bool plain = value == 0 || (magnitude >= 1e-9F && magnitude < 1e9F);
    const std::to_chars_result written =
        exponents == Exponents::allowed
            ? std::to_chars(begin, end, value)
            : std::to_chars(begin, end, value,
                            plain ? std::chars_format::fixed : std::chars_format::scientific);
    out.append(begin, written.ptr);
}

void append_row(std::string& out, const Rgb& row, Exponents exponents) {
    append_number(out, row.r, exponents);
    out += ' ';
    append_number(out, row.g, exponents);
    out += ' ';
    append_number(out, row.b, exponents);
    out += '\n';
}

void append_rows(std::string& out, std::span<const Rgb> rows, Exponents exponents) {
    for (const Rgb& row : rows) {
        append_row(out, row, exponents);
    }
}

} // namespace lutlib
