#include "preview/finish/scope_codes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace preview {

namespace {

constexpr std::int64_t always = std::numeric_limits<std::int64_t>::min(),
                       never = std::numeric_limits<std::int64_t>::max();

ScopeCodeTables::Wide wide(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    return {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)};
}

/// Light as whole numbers, as fine as three of the largest can be added.
class WholeLight {
  public:
    explicit WholeLight(double largest)
        : bits_(largest > 0 ? 60 - static_cast<int>(std::ceil(std::log2(largest))) : 60) {}

    std::int64_t operator()(double light) const {
        constexpr double limit = 4e18; // nothing that is added comes near it
        return static_cast<std::int64_t>(
            std::llround(std::clamp(std::ldexp(light, bits_), -limit, limit)));
    }

  private:
    int bits_;
};

} // namespace

ScopeCodeTables scope_code_tables(const ScopeLevels& levels) {
    const lutlib::Encoding &from = levels.shown, &to = levels.encoding.value_or(from);
    const auto [factor, top] = level_scale(levels);
    const lutlib::Matrix3 matrix = lutlib::light_to_light(from, to);
    constexpr std::size_t codes = ScopeCodeTables::codes;
    std::array<double, codes> decoded{};
    double largest = 0;
    for (std::size_t code = 0; code < codes; ++code) {
        decoded[code] = factor * from.decode(static_cast<double>(code) / 255);
        largest = std::max(largest, std::abs(decoded[code]));
    }
    double sum = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto& m = matrix.m[row];
        sum = std::max(sum, std::abs(m[0]) + std::abs(m[1]) + std::abs(m[2]));
    }
    const WholeLight whole(largest * sum);

    ScopeCodeTables out;
    out.darkest = wide(whole(to.curve->darkest));
    out.brightest = wide(whole(to.curve->brightest));
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            for (std::size_t code = 0; code < codes; ++code) {
                out.light[(row * 3 + column) * codes + code] =
                    wide(whole(matrix.m[row][column] * decoded[code]));
            }
        }
    }
    const double lowest = to.encode(to.curve->darkest), highest = to.encode(to.curve->brightest);
    out.rises[0] = wide(always);
    for (std::size_t level = 1; level < codes; ++level) {
        const double code = top * (static_cast<double>(level) - 0.5) / 255;
        out.rises[level] = wide(code <= lowest   ? always
                                : code > highest ? never
                                                 : whole(to.decode(code)));
    }
    return out;
}

} // namespace preview
