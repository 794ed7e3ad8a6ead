#include "lutlib/match/shift.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lutlib {
namespace {

constexpr int smallest = 32;      // side of a picture that can be searched
constexpr int coarsest_side = 96; // of the picture that is searched throughout
constexpr int farthest_share = 4; // of a side: a quarter
constexpr double enough_samples = 150000;
constexpr int color_steps = 8; // along each axis, of the colours before the grade
constexpr std::size_t colors = std::size_t{color_steps} * color_steps * color_steps;
constexpr std::uint16_t no_color = 0xFFFF;
// A shift must leave over so much less than none.
constexpr double worth_moving = 0.9;

struct LevelOf {
    Picture before, after;
    std::vector<std::uint16_t> color; ///< of each pixel before the grade

    LevelOf(Picture a, Picture b) : before(std::move(a)), after(std::move(b)) {
        for (const Rgb& pixel : before.pixels) {
            if (!std::isfinite(largest_magnitude(to_double(pixel)))) {
                color.push_back(no_color);
                continue;
            }
            int key = 0;
            for (const float x : {pixel.b, pixel.g, pixel.r}) {
                key = key * color_steps +
                      std::min(static_cast<int>(saturate(x) * color_steps), color_steps - 1);
            }
            color.push_back(static_cast<std::uint16_t>(key));
        }
    }
};

// Each 2x2 pixels as one. What is not finite stays so.
Picture halved(const Picture& from) {
    Picture out{from.width / 2, from.height / 2, {}};
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            out.pixels.push_back(0.25F *
                                 (from.at(2 * x, 2 * y) + from.at(2 * x + 1, 2 * y) +
                                  from.at(2 * x, 2 * y + 1) + from.at(2 * x + 1, 2 * y + 1)));
        }
    }
    return out;
}

struct Moments {
    double count = 0, squares = 0;
    RgbD sum;

    void add(RgbD c) {
        ++count;
        sum = sum + c;
        squares += c.r * c.r + c.g * c.g + c.b * c.b;
    }
    double about_mean() const {
        const double of_mean = (sum.r * sum.r + sum.g * sum.g + sum.b * sum.b) / count;
        return count > 0 ? std::max(0.0, squares - of_mean) : 0;
    }
};

struct Fit {
    double unexplained = 1; ///< share of the variance
    double left_over = 0;   ///< standard deviation of a channel
    double overlap = 0;     ///< pixels that were compared
    std::array<Moments, colors> by_color{};
};

struct Window {
    int left = 0, top = 0, right = 0, bottom = 0, step = 1;
};

// visit(color, after) for the pixels of a window of the picture before, where both are there.
template <class F>
void for_each_pair(const LevelOf& level, Pixel by, const Window& window, F&& visit) {
    const int left = std::max(window.left, -by.x), top = std::max(window.top, -by.y);
    const int right = std::min(window.right, level.after.width - by.x);
    const int bottom = std::min(window.bottom, level.after.height - by.y);
    for (int y = top; y < bottom; y += window.step) {
        const std::size_t row =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(level.before.width);
        for (int x = left; x < right; x += window.step) {
            const std::uint16_t color = level.color[row + static_cast<std::size_t>(x)];
            const RgbD after = to_double(level.after.at(x + by.x, y + by.y));
            if (color != no_color && std::isfinite(largest_magnitude(after))) {
                visit(color, after);
            }
        }
    }
}

Window whole(const LevelOf& level) {
    const double pixels = static_cast<double>(level.before.pixels.size());
    return {0, 0, level.before.width, level.before.height,
            std::max(1, static_cast<int>(std::sqrt(pixels / enough_samples)))};
}

Fit fit_at(const LevelOf& level, Pixel by) {
    Fit out;
    Moments all;
    for_each_pair(level, by, whole(level), [&](std::uint16_t color, RgbD after) {
        all.add(after);
        out.by_color[color].add(after);
    });
    double left = 0, means = 0;
    for (const Moments& of : out.by_color) {
        left += of.about_mean();
        means += of.count > 0 ? 1 : 0;
    }
    // Fewer pixels than means explain themselves.
    const double free = std::max(1.0, all.count - means), variance = all.about_mean();
    out.overlap = all.count;
    out.left_over = std::sqrt(left / free / 3);
    out.unexplained =
        variance > 0 ? std::min(1.0, left / free / (variance / std::max(1.0, all.count - 1))) : 0;
    return out;
}

struct Candidate {
    Pixel by;
    double unexplained = std::numeric_limits<double>::infinity();
};

// The best of all within so many pixels of `middle`; of equals, the nearest to it.
Pixel best_around(const LevelOf& level, Pixel middle, Pixel reach) {
    std::vector<Candidate> all;
    for (int y = -reach.y; y <= reach.y; ++y) {
        for (int x = -reach.x; x <= reach.x; ++x) {
            all.push_back({{middle.x + x, middle.y + y}});
        }
    }
    std::stable_sort(all.begin(), all.end(), [&](const Candidate& a, const Candidate& b) {
        const auto far = [&](Pixel p) {
            return std::abs(p.x - middle.x) + std::abs(p.y - middle.y);
        };
        return far(a.by) < far(b.by);
    });
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
        all[i].unexplained = fit_at(level, all[i].by).unexplained;
    });
    return std::min_element(
               all.begin(), all.end(),
               [](const Candidate& a, const Candidate& b) { return a.unexplained < b.unexplained; })
        ->by;
}

// Where a parabola through three values at -1, 0 and 1 is least.
double least_of(double before, double here, double behind) {
    const double bend = before - 2 * here + behind;
    return bend > 0 ? std::clamp((before - behind) / (2 * bend), -0.5, 0.5) : 0;
}

} // namespace

Shift find_shift(const Picture& before, const Picture& after) {
    std::vector<LevelOf> levels;
    levels.emplace_back(before, after);
    while (std::max(levels.back().before.width, levels.back().before.height) > coarsest_side &&
           std::min(levels.back().before.width, levels.back().before.height) > smallest) {
        levels.emplace_back(halved(levels.back().before), halved(levels.back().after));
    }
    Shift out;
    Fit unmoved = fit_at(levels.front(), {});
    out.explained = out.explained_unmoved = 1 - unmoved.unexplained;
    out.left_over = unmoved.left_over;
    if (std::min(before.width, before.height) < smallest || unmoved.overlap < smallest) {
        return out;
    }
    const LevelOf& coarse = levels.back();
    Pixel by = best_around(
        coarse, {}, {coarse.before.width / farthest_share, coarse.before.height / farthest_share});
    for (std::size_t i = levels.size() - 1; i-- > 0;) {
        by = best_around(levels[i], {2 * by.x, 2 * by.y}, {2, 2});
    }
    const Fit moved = fit_at(levels.front(), by);
    if (by != Pixel{} && moved.unexplained < worth_moving * unmoved.unexplained) {
        out.by = by;
        out.explained = 1 - moved.unexplained;
        out.left_over = moved.left_over;
    }
    const auto left_over = [&](int x, int y) {
        const double deviation = fit_at(levels.front(), {out.by.x + x, out.by.y + y}).left_over;
        return deviation * deviation;
    };
    const double here = left_over(0, 0);
    out.x_beyond = least_of(left_over(-1, 0), here, left_over(1, 0));
    out.y_beyond = least_of(left_over(0, -1), here, left_over(0, 1));
    return out;
}

std::optional<Pixel> distortion_in(const Picture& before, const Picture& after, Pixel by) {
    constexpr int parts = 3, reach = 4;
    // A part lies elsewhere where that leaves over so much less.
    constexpr double telling = 0.6;
    if (std::min(before.width, before.height) < parts * smallest) {
        return std::nullopt;
    }
    const LevelOf level(before, after);
    const Fit all = fit_at(level, by);
    const auto left_over = [&](const Window& window, Pixel at) {
        double out = 0, count = 0;
        for_each_pair(level, at, window, [&](std::uint16_t color, RgbD pixel) {
            const Moments& of = all.by_color[color];
            if (of.count > 0) {
                const RgbD off = pixel - 1 / of.count * of.sum;
                out += off.r * off.r + off.g * off.g + off.b * off.b;
                ++count;
            }
        });
        return count > 0 ? out / count : 0;
    };
    std::array<Pixel, std::size_t{parts} * parts> moved;
    tbb::parallel_for(0, parts * parts, [&](int part) {
        const int column = part % parts, row = part / parts;
        const Window window{before.width * column / parts, before.height * row / parts,
                            before.width * (column + 1) / parts, before.height * (row + 1) / parts,
                            whole(level).step};
        double least = telling * left_over(window, by);
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                const double left = left_over(window, {by.x + x, by.y + y});
                if (left < least) {
                    least = left;
                    moved[static_cast<std::size_t>(part)] = {x, y};
                }
            }
        }
    });
    const auto [left, right] =
        std::minmax_element(moved.begin(), moved.end(), [](Pixel a, Pixel b) { return a.x < b.x; });
    const auto [top, bottom] =
        std::minmax_element(moved.begin(), moved.end(), [](Pixel a, Pixel b) { return a.y < b.y; });
    const Pixel apart{right->x - left->x, bottom->y - top->y};
    return apart == Pixel{} ? std::nullopt : std::optional(apart);
}

Picture moved_back(const Picture& after, Pixel by) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    Picture out{after.width, after.height, {}};
    out.pixels.reserve(after.pixels.size());
    for (int y = 0; y < after.height; ++y) {
        for (int x = 0; x < after.width; ++x) {
            const int from_x = x + by.x, from_y = y + by.y;
            const bool is_there =
                from_x >= 0 && from_x < after.width && from_y >= 0 && from_y < after.height;
            out.pixels.push_back(is_there ? after.at(from_x, from_y) : Rgb{none, none, none});
        }
    }
    return out;
}

} // namespace lutlib
