#include "lutlib/match/symmetric_product.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lutlib {
namespace {

TEST(SymmetricProduct, is_that_of_the_whole_matrix_whatever_the_count_of_rows) {
    constexpr std::size_t margin = 10;
    const std::array<std::size_t, 3> offsets{1, 4, 9};
    std::uint32_t state = 1;
    const auto next = [&state] {
        state = state * 1664525 + 1013904223;
        return static_cast<double>(state >> 8) / (1 << 24) - 0.5;
    };
    for (const std::size_t count : {1U, 7U, 8U, 9U, 40U}) {
        const std::size_t length = count + 2 * margin;
        std::vector<double> own(length), x(length), out(length, 7);
        std::array<std::vector<double>, 3> entries;
        for (std::size_t k = margin; k < margin + count; ++k) {
            own[k] = next();
            x[k] = next();
        }
        std::vector<std::vector<double>> whole(count, std::vector<double>(count));
        std::vector<Diagonal> diagonals;
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            entries[i].resize(length);
            for (std::size_t k = 0; k + offsets[i] < count; ++k) {
                entries[i][margin + k] = whole[k][k + offsets[i]] = whole[k + offsets[i]][k] =
                    next();
            }
            diagonals.push_back({entries[i].data(), static_cast<std::ptrdiff_t>(offsets[i])});
        }
        symmetric_product(own.data(), diagonals, x.data(), out.data(), margin, margin + count);
        for (std::size_t k = 0; k < count; ++k) {
            double wanted = own[margin + k] * x[margin + k];
            for (std::size_t j = 0; j < count; ++j) {
                wanted += whole[k][j] * x[margin + j];
            }
            EXPECT_NEAR(out[margin + k], wanted, 1e-15) << count << ' ' << k;
        }
        EXPECT_EQ(out[margin - 1], 7);
        EXPECT_EQ(out[margin + count], 7);
    }
}

} // namespace
} // namespace lutlib
