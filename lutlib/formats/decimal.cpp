#include "lutlib/formats/decimal.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace lutlib {
namespace {

static_assert(std::endian::native == std::endian::little, "the digit loads assume little endian");

// Numbers begin within so many bytes of their row's begin, or the row is left to another reader.
constexpr std::size_t row_length = 100;
// More bytes than are looked at ahead: a sign, 8 digits, a point and 16 digits behind those.
constexpr std::size_t look_ahead = row_length + 28;
static_assert(look_ahead == rows_look_ahead);

constexpr std::array<std::uint64_t, 9> whole_power_of_ten{
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
constexpr std::array<double, 17> power_of_ten{1e0, 1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7, 1e8,
                                              1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16};

// "00000000"
constexpr std::uint64_t zeros = 0x3030303030303030U;

std::uint64_t load(const char* p) {
    std::uint64_t bytes;
    std::memcpy(&bytes, p, sizeof bytes);
    return bytes;
}

// Nonzero when one of the eight characters is no digit; the lowest set bit is in the first such.
// A byte is a digit when neither byte + 0x46 (above '9') nor byte - 0x30 (below '0') sets its top
// bit. A borrow or carry only ever runs into bytes behind the first that is no digit.
std::uint64_t no_digits(std::uint64_t bytes) {
    return ((bytes + 0x4646464646464646U) | (bytes - 0x3030303030303030U)) & 0x8080808080808080U;
}

// How many of the eight characters are digits before the first that is none.
unsigned leading_digits(std::uint64_t bytes) {
    return static_cast<unsigned>(std::countr_zero(no_digits(bytes))) / 8;
}

// The first `count` (0..8) of the eight characters as digits 0..9 with zeros before them; one that
// is no digit becomes more than 9.
std::uint64_t shifted_digits(std::uint64_t bytes, unsigned count) {
    // Shifted in two steps: by 64 at once is undefined.
    const unsigned half = 4 * (8 - count);
    return ((bytes ^ zeros) << half) << half;
}

// Nonzero when one of the eight is more than 9.
std::uint64_t above_nine(std::uint64_t digits) {
    return ((digits + 0x7676767676767676U) | digits) & 0x8080808080808080U;
}

// The number that eight digits make. Pairs, then fours, then all eight are joined by one
// multiplication each (Lemire and Langdale's integer parsing).
std::uint64_t joined_digits(std::uint64_t v) {
    v = v * 10 + (v >> 8);
    constexpr std::uint64_t mask = 0x000000FF000000FFU;
    return (((v & mask) * 0x000F424000000064U) + (((v >> 16) & mask) * 0x0000271000000001U)) >> 32;
}

// The value of the first `count` (0..8) digits of the eight characters.
std::uint64_t digits_value(std::uint64_t bytes, unsigned count) {
    return joined_digits(shifted_digits(bytes, count));
}

// mantissa / 10^decimals (both exact doubles), correctly rounded, or false when rounding twice
// might spoil it.
bool round_to_float(std::int64_t mantissa, unsigned decimals, float& out) {
    const double wide = static_cast<double>(mantissa) / power_of_ten[decimals];
    // The double is correctly rounded (Clinger 1990) and the midpoints of floats are doubles:
    // rounding twice goes wrong only from exactly such a midpoint.
    constexpr std::uint64_t below_float = (std::uint64_t{1} << 29) - 1;
    out = static_cast<float>(wide);
    return (std::bit_cast<std::uint64_t>(wide) & below_float) != (std::uint64_t{1} << 28);
}

// The form that nearly all exporters write: "d.dddddd", with everything known but the digits.
struct SixDecimals {
    std::uint64_t wrong; // 0 when the eight characters have the form
    std::int32_t millionths;
};

SixDecimals six_decimals(const char* p) {
    const std::uint64_t bytes = load(p);
    // The point gives way to the digit before it: "0ddddddd".
    const std::uint64_t digits = 0x30U | ((bytes & 0xFF) << 8) | (bytes & 0xFFFFFFFFFFFF0000U);
    const std::uint64_t no_point = (bytes & 0xFF00U) ^ (std::uint64_t{'.'} << 8);
    return {no_digits(digits) | no_point, static_cast<std::int32_t>(digits_value(digits, 8))};
}

// A row of three such numbers, 27 bytes with its line feed. Every check is made at once.
bool parse_fixed_row(const char* p, Rgb& out) {
    const SixDecimals r = six_decimals(p), g = six_decimals(p + 9), b = six_decimals(p + 18);
    const bool separated = (p[8] == ' ') & (p[17] == ' ') & (p[26] == '\n');
    // Seven digits are exact floats, and so is the divisor: one rounding each.
    out = {static_cast<float>(r.millionths) / 1e6F, static_cast<float>(g.millionths) / 1e6F,
           static_cast<float>(b.millionths) / 1e6F};
    return separated & ((r.wrong | g.wrong | b.wrong) == 0);
}

// One number at p; the character behind it, or null when it has not the plain form. Up to sixteen
// decimals are taken without a branch on their number, which varies from value to value.
const char* parse_number(const char* p, float& out) {
    const bool negative = *p == '-';
    p += negative;
    const std::uint64_t front = load(p);
    const unsigned whole = leading_digits(front);
    if (whole == 0 || whole == 8) {
        return nullptr;
    }
    std::uint64_t mantissa = digits_value(front, whole);
    unsigned decimals = 0;
    p += whole;
    if (*p == '.') {
        ++p;
        const std::uint64_t first = load(p), second = load(p + 8);
        const unsigned first_count = leading_digits(first);
        const unsigned second_count = first_count == 8 ? leading_digits(second) : 0;
        decimals = first_count + second_count;
        mantissa = mantissa * whole_power_of_ten[first_count] + digits_value(first, first_count);
        mantissa = mantissa * whole_power_of_ten[second_count] + digits_value(second, second_count);
        p += decimals;
    }
    if (whole + decimals > 15 ||
        !round_to_float(static_cast<std::int64_t>(mantissa), decimals, out)) {
        return nullptr;
    }
    out = negative ? -out : out;
    return p;
}

bool blank(char c) {
    return c == ' ' || c == '\t';
}

// A bit for each of the 48 characters from p on that is a blank or a control character.
std::uint64_t separators(const char* p) {
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < 48; i += 8) {
        const std::uint64_t bytes = load(p + i);
        // The top bit of each byte above ' '; the sums stay within their bytes.
        const std::uint64_t others = ((bytes & 0x7F7F7F7F7F7F7F7FU) + 0x5F5F5F5F5F5F5F5FU) | bytes;
        const std::uint64_t found = (~others & 0x8080808080808080U) >> 7;
        // Gathers the lowest bits of the eight bytes in the top one.
        bits |= (found * 0x0102040810204080U) >> 56 << i;
    }
    return bits;
}

// The bytes of the first 0..14 decimals in two words, the first 8 and the next 6.
struct DecimalMasks {
    std::array<std::array<std::uint64_t, 2>, 15> of{};
    constexpr DecimalMasks() {
        for (std::size_t count = 0; count < of.size(); ++count) {
            for (std::size_t i = 0; i < count; ++i) {
                of[count][i / 8] |= std::uint64_t{0xFF} << (i % 8 * 8);
            }
        }
    }
};
constexpr DecimalMasks decimal_masks;

// "[-]d[.dddd]", as shortest decimals are, of known length. Always read as a number of 14 decimals,
// of which those behind its own are zeros, so that nothing depends on how long it is.
struct ShortDecimal {
    std::uint64_t wrong; // 0 when the characters have the form
    float value;
};

ShortDecimal short_decimal(const char* p, std::size_t length) {
    const bool negative = *p == '-';
    p += negative;
    length -= negative;
    const std::size_t decimals = length < 2 ? 0 : length - 2;
    const auto& mask = decimal_masks.of[std::min<std::size_t>(decimals, 14)];
    const std::uint64_t front = (load(p + 2) ^ zeros) & mask[0];
    const std::uint64_t back = (load(p + 10) ^ zeros) & mask[1];
    const std::uint64_t whole = static_cast<unsigned char>(*p) - std::uint64_t{'0'};
    const std::uint64_t mantissa =
        whole * 100000000000000U + joined_digits(front) * 1000000U + joined_digits(back << 16);
    ShortDecimal out;
    const bool exact = round_to_float(static_cast<std::int64_t>(mantissa), 14, out.value);
    const bool point = (length == 1) | (p[1] == '.');
    out.wrong = above_nine(front) | above_nine(back) |
                static_cast<std::uint64_t>(!exact | !point | (whole > 9) | (decimals > 14));
    out.value = negative ? -out.value : out.value;
    return out;
}

// A row of three such numbers with single separators: its length with the line feed, or 0.
std::size_t parse_short_row(const char* p, Rgb& out) {
    const std::uint64_t first = separators(p), second = first & (first - 1),
                        third = second & (second - 1);
    if (third == 0) {
        return 0;
    }
    const auto a = static_cast<std::size_t>(std::countr_zero(first)),
               b = static_cast<std::size_t>(std::countr_zero(second)),
               c = static_cast<std::size_t>(std::countr_zero(third));
    const ShortDecimal red = short_decimal(p, a), green = short_decimal(p + a + 1, b - a - 1),
                       blue = short_decimal(p + b + 1, c - b - 1);
    out = {red.value, green.value, blue.value};
    const bool carriage = p[c] == '\r';
    const bool separated = blank(p[a]) && blank(p[b]) && p[c + carriage] == '\n';
    return separated && (red.wrong | green.wrong | blue.wrong) == 0 ? c + carriage + 1 : 0;
}

// A number of any other form that from_chars reads as a finite float, such as 1.5e-07.
const char* parse_general(const char* p, const char* end, float& out) {
    const auto [stop, status] = std::from_chars(p, end, out);
    return status == std::errc{} && std::isfinite(out) ? stop : nullptr;
}

const char* parse_any(const char* p, const char* end, float& out) {
    if (p >= end) {
        return nullptr;
    }
    const char* const q = parse_number(p, out);
    return q && (blank(*q) || *q == '\n' || *q == '\r') ? q : parse_general(p, end, out);
}

} // namespace

RowRun parse_rows(std::string_view text, Rgb* out, std::size_t most) {
    RowRun run;
    if (text.size() < look_ahead) {
        return run;
    }
    const char* const last = text.data() + text.size() - look_ahead;
    const char* p = text.data();
    constexpr std::size_t fixed_length = 27;
    std::size_t length = fixed_length; // of the last row: the next one is likely of its kind
    while (run.rows < most && p < last) {
        Rgb row;
        const bool fixed = length == fixed_length && parse_fixed_row(p, row);
        length = fixed ? fixed_length : parse_short_row(p, row);
        if (length > 0) {
            out[run.rows++] = row;
            p += length;
            continue;
        }
        const char* const end = p + row_length;
        const char* q = parse_any(p, end, row.r);
        if (!q || !blank(*q)) {
            break;
        }
        q = parse_any(q + 1, end, row.g);
        if (!q || !blank(*q)) {
            break;
        }
        q = parse_any(q + 1, end, row.b);
        if (!q) {
            break;
        }
        q += *q == '\r' && q[1] == '\n';
        if (*q != '\n') {
            break;
        }
        out[run.rows++] = row;
        p = q + 1;
    }
    run.bytes = static_cast<std::size_t>(p - text.data());
    return run;
}

} // namespace lutlib
