#include "preview/reference/stylised.h"

#include "preview/reference/hash.h"

#include <numbers>

namespace preview::reference {

using lutlib::RgbD;

Image glitched(const Image& picture, const Glitch& glitch) {
    Image out = picture;
    const auto nearest = [](double v) { return static_cast<int>(std::floor(v + 0.5)); };
    for (int y = 0; y < out.height; ++y) {
        const auto line = static_cast<std::uint32_t>(y / glitch.line);
        const Words of_line = pcg3d(0x6c696e65U, line, glitch.moment);
        const bool is_torn = unit_of(of_line[0]) < glitch.torn_lines;
        const int torn = is_torn ? nearest(glitch.tear * (2 * unit_of(of_line[1]) - 1)) : 0;
        for (int x = 0; x < out.width; ++x) {
            const double border = 2 * (x + 0.5) / out.width - 1;
            const int green = nearest(glitch.green_shift * border * std::abs(border));
            RgbD color = picture.clamped(x + torn, y);
            color.g = picture.clamped(x + torn + green, y).g;
            const Words grain =
                pcg3d(static_cast<std::uint32_t>(x / glitch.line), line, glitch.moment);
            for (std::size_t c = 0; c < 3; ++c) {
                color[c] += glitch.noise * triangular_of(grain[0]);
            }
            out.at(x, y) = saturated(color);
        }
    }
    return out;
}

Image vaporwave(const Image& picture, const std::vector<bool>& is_background,
                const Vaporwave& vaporwave) {
    const RgbD dark{0.10, 0.02, 0.24}, light{1.0, 0.76, 0.96};
    const RgbD fields[]{{0.23, 0.07, 0.45}, {0.98, 0.36, 0.76}};
    // Even fields from 0 to 1, odd ones from 1 to 2; an edge is one texel wide.
    const auto wave = [&](double place) {
        const double phase = place - 2 * std::floor(place / 2);
        const double from_edge = std::min({std::abs(phase), std::abs(phase - 1), 2 - phase});
        const double soft = std::min(from_edge * vaporwave.field, 0.5);
        return phase < 1 ? soft : -soft;
    };
    Image out = picture;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const RgbD own = picture.at(x, y);
            RgbD color = mixed(mixed(dark, light, luma_of(own)), own, 0.3);
            if (is_background[static_cast<std::size_t>(y * out.width + x)]) {
                // A half field on from where the shader counts, whose wave is greatest there.
                const double along = wave((x + 0.5) / vaporwave.field + vaporwave.moved - 0.5);
                const double down = wave((y + 0.5) / vaporwave.field - 0.5);
                color = mixed(fields[0], fields[1], 0.5 + 2 * along * down);
            }
            out.at(x, y) = mixed(own, color, vaporwave.strength);
        }
    }
    return out;
}

namespace {

/// The mean of up to 8x8 texels of a cell.
RgbD mean_of(const Image& picture, int column, int row, double cell) {
    const int samples = std::clamp(static_cast<int>(cell), 1, 8);
    RgbD sum{};
    for (int y = 0; y < samples; ++y) {
        for (int x = 0; x < samples; ++x) {
            sum = sum + picture.clamped(static_cast<int>((column + (x + 0.5) / samples) * cell),
                                        static_cast<int>((row + (y + 0.5) / samples) * cell));
        }
    }
    return sum * (1.0 / (samples * samples));
}

double radius_of(double share) {
    const double whole = std::numbers::pi / 4;
    return share <= whole ? std::sqrt(share / std::numbers::pi)
                          : 0.5 + (std::sqrt(0.5) - 0.5) *
                                      (1 - std::sqrt(std::max(1 - share, 0.0) / (1 - whole)));
}

} // namespace

Image pointillism(const Image& picture, const Pointillism& pointillism) {
    const double cell = pointillism.cell;
    Image means(static_cast<int>(std::ceil(picture.width / cell)),
                static_cast<int>(std::ceil(picture.height / cell)));
    for (int y = 0; y < means.height; ++y) {
        for (int x = 0; x < means.width; ++x) {
            means.at(x, y) = mean_of(picture, x, y, cell);
        }
    }
    Image out = picture;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const double px = (x + 0.5) / cell, py = (y + 0.5) / cell;
            RgbD color{1, 1, 1};
            for (int n = 0; n < 9; ++n) {
                const int cx = static_cast<int>(px) + n % 3 - 1;
                const int cy = static_cast<int>(py) + n / 3 - 1;
                if (cx < 0 || cy < 0 || cx >= means.width || cy >= means.height) {
                    continue;
                }
                const RgbD mean = means.at(cx, cy);
                const double share = pointillism.is_colored ? 1 - std::min({mean.r, mean.g, mean.b})
                                                            : 1 - luma_of(mean);
                RgbD ink{};
                for (std::size_t c = 0; c < 3 && pointillism.is_colored; ++c) {
                    ink[c] = std::clamp(1 - (1 - mean[c]) / std::max(share, 1e-4), 0.0, 1.0);
                }
                const double away = std::hypot(px - cx - 0.5, py - cy - 0.5);
                const double inside = std::clamp((radius_of(share) - away) * cell + 0.5, 0.0, 1.0) *
                                      std::min(share * cell * cell, 1.0);
                color = mixed(color, ink, inside);
            }
            out.at(x, y) = mixed(picture.at(x, y), color, pointillism.strength);
        }
    }
    return out;
}

} // namespace preview::reference
