#include "lutlib/verify/palette.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lutlib {
namespace {

constexpr std::size_t palette = 256, many = 2 * palette;
// A palette chosen for the picture leaves a twentieth, dithered a tenth.
constexpr double most_error = 0.2;

std::uint64_t packed(const std::array<int, 3>& codes) {
    std::uint64_t out = 0;
    for (const int code : codes) {
        out = out << 16 | static_cast<std::uint64_t>(code);
    }
    return out;
}

std::size_t distinct(std::vector<std::uint64_t>& colors) {
    std::sort(colors.begin(), colors.end());
    return static_cast<std::size_t>(std::unique(colors.begin(), colors.end()) - colors.begin());
}

} // namespace

std::optional<std::string> few_colors(const CodeImage& picture, const Engine& engine, int size,
                                      const Transform& look) {
    const auto [pixels, values] = right_texels(picture, engine, size, look);
    std::vector<std::uint64_t> found, right;
    RgbD sum, squares;
    double errors = 0;
    bool colored = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::array<int, 3> is{}, should{};
        for (std::size_t c = 0; c < 3; ++c) {
            is[c] = picture.at(pixels[i], c);
            should[c] = picture.depth.code(values[i][c]);
            const double code = should[c], error = is[c] - should[c];
            sum[c] += code;
            squares[c] += code * code;
            errors += error * error;
        }
        colored = colored || is[0] != is[1] || is[1] != is[2];
        found.push_back(packed(is));
        right.push_back(packed(should));
    }
    const auto count = static_cast<double>(values.size());
    double variance = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        variance += squares[c] - sum[c] * sum[c] / count;
    }
    const std::size_t colors = distinct(found), wanted = distinct(right);
    if (!colored || colors > palette || wanted < many || errors > most_error * variance) {
        return std::nullopt;
    }
    return "the picture has " + std::to_string(colors) + " colours where the look has " +
           std::to_string(wanted) +
           ": it was saved with a palette, as a GIF or a PNG of indexed colours; save it as RGB";
}

} // namespace lutlib
