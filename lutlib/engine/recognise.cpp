#include "lutlib/engine/recognise.h"

#include "lutlib/error.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lutlib {
namespace {

// How much clearer than the runner-up the best reading must be.
constexpr double clear_margin = 0.05;

// For each axis of the lattice, how much each channel rises along it in sum, and how far it moves.
struct AxisGrowth {
    std::array<std::array<double, 3>, 3> rise{}; // [axis][channel]
    std::array<std::array<double, 3>, 3> travel{};
};

AxisGrowth growth_of(const Lut3D& cube) {
    AxisGrowth out;
    const int n = cube.size;
    const std::array<std::size_t, 3> step{1, cube.index(0, 1, 0), cube.index(0, 0, 1)};
    for (int b = 0; b < n; ++b) {
        for (int g = 0; g < n; ++g) {
            for (int r = 0; r < n; ++r) {
                const std::array<int, 3> node{r, g, b};
                const std::size_t here = cube.index(r, g, b);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    if (node[axis] + 1 == n) {
                        continue;
                    }
                    const Rgb delta = cube.nodes[here + step[axis]] - cube.nodes[here];
                    for (std::size_t c = 0; c < 3; ++c) {
                        out.rise[axis][c] += static_cast<double>(delta[c]);
                        out.travel[axis][c] += std::abs(static_cast<double>(delta[c]));
                    }
                }
            }
        }
    }
    return out;
}

// Two marks, each 1 for an identity. Monotony: along its own axis a channel should rise and not
// oscillate, which it does when slices or rows are taken from the wrong places. Ownership: of all
// the rise of a channel its own axis should have the most, which tells swapped axes.
double score_of(const Lut3D& cube) {
    const AxisGrowth growth = growth_of(cube);
    double travelled = 0, monotony = 0, ownership = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        double all = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            all += growth.travel[axis][c];
            monotony += std::abs(growth.rise[axis][c]);
        }
        travelled += all;
        ownership += growth.rise[c][c];
    }
    return travelled > 0 ? 0.5 * (monotony + ownership) / travelled : 0;
}

std::string describe(const Recognition& reading) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%.*s of size %d (score %.2f)",
                  static_cast<int>(reading.layout->name.size()), reading.layout->name.data(),
                  reading.size, reading.score);
    return text.data();
}

} // namespace

std::vector<Recognition> recognise(const Picture& picture) {
    std::vector<Recognition> out;
    for (const Layout& layout : layouts()) {
        for (int n = limits::min_cube_size; n <= limits::max_cube_size; ++n) {
            const std::optional<PictureSize> size = layout.picture(n);
            if (!size || size->width != picture.width || picture.height % size->height != 0) {
                continue;
            }
            const int rows = picture.height / size->height;
            out.push_back({&layout, n, rows, score_of(from_picture(picture, layout, n))});
        }
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
    return out;
}

Recognition recognise_one(const Picture& picture, const std::string& file) {
    const std::vector<Recognition> readings = recognise(picture);
    if (readings.empty()) {
        throw Error("no LUT layout has " + std::to_string(picture.width) + "x" +
                        std::to_string(picture.height) +
                        " pixels; strips are N*N x N, HALDs and tiles are square",
                    {file, 0, {}});
    }
    const bool clear =
        readings.size() == 1 || readings[0].score - readings[1].score >= clear_margin;
    if (readings[0].score <= 0 || !clear) {
        std::string candidates;
        for (const Recognition& reading : readings) {
            candidates += (candidates.empty() ? "" : ", ") + describe(reading);
        }
        throw Error("the layout cannot be told from the content; name it, as an engine's (verify "
                    "--engine) or by itself (convert --from). Candidates: " +
                        candidates,
                    {file, 0, {}});
    }
    return readings[0];
}

} // namespace lutlib
