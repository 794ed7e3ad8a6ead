#include "preview/reference/scopes.h"

#include <algorithm>

namespace preview::reference {

namespace {

// In 65536ths; the weights of luma add up to one, those of a difference to zero.
constexpr int luma_weights[3] = {13933, 46871, 4732};
constexpr int cb_weights[3] = {-7509, -25259, 32768};
constexpr int cr_weights[3] = {32768, -29763, -3005};

std::size_t weighed(const int (&weights)[3], const std::uint8_t* rgb, int neutral) {
    const int sum = weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2];
    return static_cast<std::size_t>(std::min(((sum + 32768) >> 16) + neutral, 255));
}

} // namespace

std::vector<std::uint32_t> scope_counts(const Scope& scope, std::span<const std::uint8_t> rgba,
                                        std::uint32_t width, const ScopeArea& area,
                                        std::uint32_t columns) {
    std::vector<std::uint32_t> counts(preview::scope_counts(scope, columns));
    for (std::uint32_t row = 0; row < area.height; ++row) {
        for (std::uint32_t i = 0; i < area.columns(); ++i) {
            const std::uint32_t x = area.x + i % area.width + i / area.width * area.stride;
            const std::uint32_t y = area.y + row;
            if (!is_counted(area, x, y)) {
                continue;
            }
            const std::uint8_t* const rgb = &rgba[4 * (std::size_t{y} * width + x)];
            const std::size_t luma = weighed(luma_weights, rgb, 0);
            switch (scope.bins) {
            case ScopeBins::columns:
                for (std::size_t plane = 0; plane < scope.planes; ++plane) {
                    const std::size_t level = scope.planes == 1 ? luma : rgb[plane];
                    const std::size_t column = std::size_t{i} * columns / area.columns();
                    ++counts[(plane * columns + column) * scope_levels + level];
                }
                break;
            case ScopeBins::chroma:
                ++counts[weighed(cr_weights, rgb, 128) * scope_levels +
                         weighed(cb_weights, rgb, 128)];
                break;
            case ScopeBins::levels:
                for (std::size_t plane = 0; plane < 4; ++plane) {
                    ++counts[plane * scope_levels + (plane < 3 ? rgb[plane] : luma)];
                }
                break;
            }
        }
    }
    return counts;
}

std::vector<std::uint8_t> scope_codes(std::span<const std::uint8_t> rgba,
                                      const ScopeLevels& levels) {
    const lutlib::Encoding &from = levels.shown, &to = levels.encoding.value_or(from);
    const lutlib::Matrix3 matrix = lutlib::light_to_light(from, to);
    const auto [factor, top] = level_scale(levels);
    std::vector<std::uint8_t> out(rgba.size(), 255);
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
        const lutlib::RgbD light =
            matrix * lutlib::RgbD{from.decode(rgba[i] / 255.0), from.decode(rgba[i + 1] / 255.0),
                                  from.decode(rgba[i + 2] / 255.0)};
        for (std::size_t c = 0; c < 3; ++c) {
            const double code = lutlib::saturate(to.encode(factor * light[c]) / top);
            out[i + c] = static_cast<std::uint8_t>(255 * code + 0.5);
        }
    }
    return out;
}

} // namespace preview::reference
