#include "lutlib/formats/decimal.h"

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

constexpr std::array<std::uint64_t, 9> whole_power_of_ten{
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
constexpr std::array<double, 17> power_of_ten{1e0, 1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7, 1e8,
                                              1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16};

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

// The value of the first `count` (0..8) digits of the eight characters. Pairs, then fours, then
// all eight are joined by one multiplication each (Lemire and Langdale's integer parsing).
std::uint64_t digits_value(std::uint64_t bytes, unsigned count) {
    // Shifted in two steps: by 64 at once is undefined.
    const unsigned half = 4 * (8 - count);
    std::uint64_t v = ((bytes - 0x3030303030303030U) << half) << half;
    v = v * 10 + (v >> 8);
    constexpr std::uint64_t mask = 0x000000FF000000FFU;
    return (((v & mask) * 0x000F424000000064U) + (((v >> 16) & mask) * 0x0000271000000001U)) >> 32;
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
    while (run.rows < most && p < last) {
        Rgb row;
        if (parse_fixed_row(p, row)) {
            out[run.rows++] = row;
            p += 27;
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
