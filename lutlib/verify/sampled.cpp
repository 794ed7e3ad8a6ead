#include "lutlib/verify/sampled.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// Of f (1 - f) summed over the axes, at most three quarters.
constexpr double near_nodes = 0.13, between_nodes = 0.4;
constexpr std::size_t least_texels = 8;
// Squared codes of 8 bits beyond rounding; differences below are not worth a word.
constexpr double least_square = 0.1;
// Of what lies between; noise and other looks leave about as much near the nodes.
constexpr double most_near_nodes = 0.15;
constexpr double rounding_square = 1.0 / 12;

// f (1 - f) of a place between two nodes; nullopt beyond the outermost.
std::optional<double> off_nodes(const std::vector<double>& nodes, double in) {
    const auto above = std::lower_bound(nodes.begin(), nodes.end(), in);
    if (above == nodes.end() || (above == nodes.begin() && in < *above)) {
        return std::nullopt;
    }
    if (above == nodes.begin()) {
        return 0.0;
    }
    const double low = *(above - 1), f = (in - low) / (*above - low);
    return f * (1 - f);
}

// Of the way from the first to the last input: nodes nearer to the ends say nothing, for most
// mistakes leave black, white and what is beside them nearly as it is.
constexpr double ends = 0.1;
// Of what lies between nodes; a mistake in a few slices leaves most as it is.
constexpr double least_wrong_between = 0.5;

struct Group {
    double squares = 0; ///< in codes of 8 bits, less what rounding leaves
    std::size_t texels = 0;
    std::size_t wrong = 0;

    double mean() const { return squares / (3 * static_cast<double>(texels)); }
};

} // namespace

std::optional<std::string> sampling_between_nodes(const CodeImage& picture, const Engine& engine,
                                                  int size, const Transform& look,
                                                  const Breaks& breaks) {
    std::array<std::vector<std::optional<double>>, 3> off;
    for (std::size_t c = 0; c < 3; ++c) {
        if (!breaks.all || breaks.at[c].size() < 3) {
            return std::nullopt;
        }
        for (int i = 0; i < size; ++i) {
            off[c].push_back(off_nodes(breaks.at[c], engine.node_input(i, size)));
        }
    }
    const auto [pixels, values] = right_texels(picture, engine, size, look);
    const double maximum = picture.depth.maximum(), in_8_bits = 255 / maximum;
    Group near, between;
    double largest = 0;
    const auto n = static_cast<std::size_t>(size);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto &r = off[0][i % n], &g = off[1][i / n % n], &b = off[2][i / n / n];
        if (!r || !g || !b) {
            continue;
        }
        double squares = 0, furthest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double error = picture.at(pixels[i], c) - saturate(values[i][c]) * maximum;
            squares += std::max(error * error - rounding_square, 0.0) * in_8_bits * in_8_bits;
            furthest = std::max(furthest, std::abs(error));
        }
        largest = std::max(largest, furthest);
        const auto is_inside = [&](std::size_t node) {
            const double way = static_cast<double>(node) / static_cast<double>(size - 1);
            return way > ends && way < 1 - ends;
        };
        const bool inside = is_inside(i % n) || is_inside(i / n % n) || is_inside(i / n / n);
        const double place = *r + *g + *b;
        Group* const group = place <= near_nodes      ? (inside ? &near : nullptr)
                             : place >= between_nodes ? &between
                                                      : nullptr;
        if (place < 1e-9 && furthest * in_8_bits > 1) {
            return std::nullopt; // wrong at a node itself
        }
        if (group) {
            group->squares += squares;
            ++group->texels;
            group->wrong += furthest > 0.51 ? 1 : 0;
        }
    }
    if (near.texels < least_texels || between.texels < least_texels ||
        between.mean() < least_square || near.mean() > most_near_nodes * between.mean() ||
        static_cast<double>(between.wrong) <
            least_wrong_between * static_cast<double>(between.texels)) {
        return std::nullopt;
    }
    return "the picture is right at the look's nodes and differs between them, by " +
           std::to_string(std::lround(largest)) +
           " codes at most: it was baked from what this LUT of " +
           std::to_string(breaks.at[0].size()) +
           " nodes was sampled from, such as its recipe; verify it against that";
}

} // namespace lutlib
