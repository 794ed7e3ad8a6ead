// How much a test looks at: enough to see a mistake, or all there is.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <type_traits>
#include <vector>

namespace support {

/// Whether this program checks its own memory, which takes some five times as long.
#if defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

/// `scripts/test --all` asks for every input; else tests that take many take fewer.
inline bool is_thorough() {
    return std::getenv("LUT_TEST_ALL") != nullptr;
}

/// For tests that compute for minutes under sanitizers what shorter ones compute too.
inline bool is_too_long_here() {
    return is_sanitized && !is_thorough();
}

template <class T>
std::vector<T> all_or(std::vector<T> all, std::vector<T> some) {
    return is_thorough() ? all : some;
}

/// All rows; under sanitizers every third, for what those see is the same in each.
template <class Rows>
auto rows_to_try(const Rows& rows) {
    constexpr std::size_t step = is_sanitized ? 3 : 1;
    std::vector<std::decay_t<decltype(*std::begin(rows))>> out;
    std::size_t index = 0;
    for (const auto& row : rows) {
        if (index++ % step == 0) {
            out.push_back(row);
        }
    }
    return out;
}

} // namespace support
