#include "preview/reference/paintbrush.h"

#include "preview/reference/hash.h"
#include "preview/reference/noise.h"

#include <numbers>

namespace preview::reference {

namespace {

using lutlib::RgbD;

struct Stroke {
    double x = 0, y = 0, along_x = 1, along_y = 0, height = 0;
    RgbD color{};
};

struct Direction {
    double x, y;
};

Direction unit_or_along_x(double x, double y) {
    const double length = std::hypot(x, y);
    return length > 1e-6 ? Direction{x / length, y / length} : Direction{1, 0};
}

/// The slope of the noise by differences.
Direction slope_of(glm::dvec3 p) {
    constexpr double h = 1e-5;
    return {(perlin(p + glm::dvec3(h, 0, 0)) - perlin(p - glm::dvec3(h, 0, 0))) / (2 * h),
            (perlin(p + glm::dvec3(0, h, 0)) - perlin(p - glm::dvec3(0, h, 0))) / (2 * h)};
}

Stroke stroke_of(const Image& picture, int column, int row, const Paintbrush& brush) {
    const Words bits =
        pcg3d(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), 1);
    Stroke out;
    out.x = column + 0.5 + 0.8 * (unit_of(bits[0]) - 0.5);
    out.y = row + 0.5 + 0.8 * (unit_of(bits[1]) - 0.5);
    const Direction slope =
        slope_of({out.x * brush.frequency, out.y * brush.frequency, brush.depth});
    const Direction curl = unit_or_along_x(slope.y, -slope.x);
    const double turn = 2 * std::numbers::pi * unit_of(bits[2]);
    const Direction along =
        unit_or_along_x(std::cos(turn) + brush.coherence * (curl.x - std::cos(turn)),
                        std::sin(turn) + brush.coherence * (curl.y - std::sin(turn)));
    out.along_x = along.x;
    out.along_y = along.y;
    for (int i = -1; i <= 1; ++i) {
        const RgbD texel =
            picture.clamped(static_cast<int>(std::floor((out.x + 0.3 * i * along.x) * brush.cell)),
                            static_cast<int>(std::floor((out.y + 0.3 * i * along.y) * brush.cell)));
        out.color = out.color + texel * (1.0 / 3);
    }
    out.height = unit_of(pcg3d(bits[0], bits[1], bits[2])[0]);
    return out;
}

/// Even noise between the points of a grid of four to a cell.
double fray_at(double x, double y) {
    const double left = std::floor(4 * x), top = std::floor(4 * y);
    double sum = 0;
    for (int n = 0; n < 4; ++n) {
        const double px = left + n % 2, py = top + n / 2;
        const Words words = pcg3d(static_cast<std::uint32_t>(static_cast<int>(px)),
                                  static_cast<std::uint32_t>(static_cast<int>(py)), 2);
        sum += (1 - std::abs(4 * x - px)) * (1 - std::abs(4 * y - py)) * unit_of(words[0]);
    }
    return 2 * sum - 1;
}

} // namespace

Image painted(const Image& picture, const Paintbrush& brush) {
    constexpr int margin = 2;
    const int columns = static_cast<int>(std::ceil(picture.width / brush.cell)) + 2 * margin;
    const int rows = static_cast<int>(std::ceil(picture.height / brush.cell)) + 2 * margin;
    std::vector<Stroke> strokes;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            strokes.push_back(stroke_of(picture, column - margin, row - margin, brush));
        }
    }
    Image out = picture;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const double px = (x + 0.5) / brush.cell, py = (y + 0.5) / brush.cell;
            const double fray = 0.25 * fray_at(px, py);
            RgbD sum{};
            double weights = 0;
            // All strokes of the picture: the shader looks at those near by.
            for (const Stroke& stroke : strokes) {
                const double dx = px - stroke.x, dy = py - stroke.y;
                const double u = (dx * stroke.along_x + dy * stroke.along_y) / brush.half_length;
                const double v = (dy * stroke.along_x - dx * stroke.along_y) / stroke_half_width;
                const double inside = std::clamp((1 - std::hypot(u, v) + fray) * 3, 0.0, 1.0);
                const double weight =
                    inside * inside * (3 - 2 * inside) * std::exp2(14 * stroke.height);
                sum = sum + stroke.color * weight;
                weights += weight;
            }
            const RgbD own = picture.at(x, y);
            out.at(x, y) = mixed(own, weights > 1e-3 ? sum * (1 / weights) : own, brush.strength);
        }
    }
    return out;
}

} // namespace preview::reference
