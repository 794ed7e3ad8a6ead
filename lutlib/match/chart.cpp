#include "lutlib/match/chart.h"

#include "lutlib/color/luma.h"
#include "lutlib/color/swatches.h"
#include "lutlib/error.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lutlib {
namespace {

static_assert(color_checker.size() == chart_patches);
constexpr int long_side = 6, short_side = 4;
constexpr int least_patch = 4; // pixels each way
// Of a patch's side, from its middle to where its edges may lie.
constexpr double kept = 0.2;
// Of the lightness of the patches, what a chart's must follow the published one by. The published
// one turned or mirrored follows itself by 0.36 at most, so that only one way can reach this.
constexpr double chart_from = 0.8;

using Patches = std::array<RgbD, chart_patches>;

std::optional<RgbD> median_of(const Picture& picture, double left, double right, double top,
                              double bottom) {
    std::array<std::vector<double>, 3> channels;
    for (int y = static_cast<int>(std::ceil(top)); y < bottom; ++y) {
        for (int x = static_cast<int>(std::ceil(left)); x < right; ++x) {
            const RgbD c = to_double(picture.at(x, y));
            if (std::isfinite(largest_magnitude(c))) {
                for (std::size_t i = 0; i < 3; ++i) {
                    channels[i].push_back(c[i]);
                }
            }
        }
    }
    if (channels[0].empty()) {
        return std::nullopt;
    }
    RgbD out;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto middle =
            channels[i].begin() + static_cast<std::ptrdiff_t>(channels[i].size() / 2);
        std::nth_element(channels[i].begin(), middle, channels[i].end());
        out[i] = *middle;
    }
    return out;
}

// Row by row as they lie in the picture.
Patches patches_in(const Picture& picture, const ChartArea& area, int columns, int rows) {
    Patches out;
    const double w = static_cast<double>(area.width) / columns,
                 h = static_cast<double>(area.height) / rows;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x = area.left + (column + 0.5) * w, y = area.top + (row + 0.5) * h;
            const std::optional<RgbD> found =
                median_of(picture, x - kept * w, x + kept * w, y - kept * h, y + kept * h);
            if (!found) {
                throw Error("a patch of its chart has no pixel that is there");
            }
            out[static_cast<std::size_t>(row * columns + column)] = *found;
        }
    }
    return out;
}

// Where the patch of a published column and row lies, of a chart on its side or not, from the other
// end along either axis.
std::size_t place_of(std::size_t patch, bool on_side, bool from_right, bool from_below) {
    const auto n = static_cast<std::size_t>(long_side);
    std::size_t column = patch % n, row = patch / n;
    column = from_right ? n - 1 - column : column;
    row = from_below ? short_side - 1 - row : row;
    return on_side ? column * short_side + row : row * n + column;
}

Patches ordered(const Patches& lying, bool on_side, bool from_right, bool from_below) {
    Patches out;
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = lying[place_of(i, on_side, from_right, from_below)];
    }
    return out;
}

// The share of the published lightnesses' variance that a line through these leaves over; all of it
// where they fall as those rise.
double unexplained(const Patches& patches, const Patches& published) {
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const double is = luma(patches[i]), wanted = luma(published[i]);
        x += is;
        y += wanted;
        xx += is * is;
        xy += is * wanted;
        yy += wanted * wanted;
    }
    constexpr double n = chart_patches;
    const double spread = xx - x * x / n, both = xy - x * y / n, all = yy - y * y / n;
    return spread > 0 && both > 0 ? 1 - both * both / (spread * all) : 1;
}

} // namespace

Patches published_chart() {
    Patches out;
    for (std::size_t i = 0; i < out.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out[i][c] = color_checker[i].srgb[c] / 255.0;
        }
    }
    return out;
}

Patches chart_in(const Picture& picture, const ChartArea& area) {
    if (area.left < 0 || area.top < 0 || area.width > picture.width - area.left ||
        area.height > picture.height - area.top) {
        throw Error("the chart's rectangle reaches beyond its " + std::to_string(picture.width) +
                    "x" + std::to_string(picture.height) + " pixels");
    }
    const bool on_side = area.height > area.width;
    const int columns = on_side ? short_side : long_side, rows = on_side ? long_side : short_side;
    if (area.width < least_patch * columns || area.height < least_patch * rows) {
        throw Error("the chart's rectangle is too small: a patch needs 4x4 pixels");
    }
    const Patches lying = patches_in(picture, area, columns, rows), published = published_chart();
    Patches best{};
    double least = 2;
    for (const bool from_right : {false, true}) {
        for (const bool from_below : {false, true}) {
            const Patches turned = ordered(lying, on_side, from_right, from_below);
            const double left = unexplained(turned, published);
            if (left < least) {
                least = left;
                best = turned;
            }
        }
    }
    if (least > 1 - chart_from) {
        throw Error("no ColorChecker lies in that rectangle: the lightness of its 24 patches is "
                    "not the published one's in any direction; give the rectangle from the outer "
                    "edges of the outer patches, X,Y,WIDTH,HEIGHT");
    }
    return best;
}

} // namespace lutlib
