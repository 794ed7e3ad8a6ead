#include "preview/reference/depth_of_field_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace preview::reference {

namespace {

using lutlib::RgbD;

constexpr int tile = 16; ///< cells a side that share a reach

double before_share(double radius) {
    return std::clamp(-radius - 0.5, 0.0, 1.0);
}

double behind_share(double radius) {
    return std::clamp(radius - 0.5, 0.0, 1.0);
}

double covers(double radius, double distance) {
    return std::clamp(radius - distance + 0.5, 0.0, 1.0);
}

struct Cell {
    RgbD rest{}, near{};
    double radius = 0;      ///< of the rest, in cells; -1: nothing is known of it
    double opacity = 0;     ///< of what is before the focus
    double near_radius = 0; ///< of that
};

class CellGrid {
  public:
    int width = 0, height = 0;
    std::vector<Cell> all;

    CellGrid(int w, int h)
        : width(w), height(h), all(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    const Cell& clamped(int x, int y) const {
        return at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
    }
    const Cell& at(int x, int y) const { return all[index(x, y)]; }
    Cell& at(int x, int y) { return all[index(x, y)]; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

struct Point {
    double x, y, distance;
};

std::vector<Point> disc_of(int rings) {
    std::vector<Point> out{{0, 0, 0}};
    for (int ring = 1; ring <= rings; ++ring) {
        const double distance = 2.0 * ring / (2 * rings + 1);
        for (int i = 0; i < 8 * ring; ++i) {
            const double turn = std::numbers::pi * (2 * i + ring % 2) / (8 * ring);
            out.push_back({distance * std::cos(turn), distance * std::sin(turn), distance});
        }
    }
    return out;
}

class Blur {
  public:
    Blur(const Image& light, const std::vector<double>& radii, const CellBlur& asked)
        : light_(light), radii_(radii), side_(asked.cell), texel_(1.0 / asked.cell),
          largest_(asked.largest / asked.cell), disc_(disc_of(asked.rings)),
          cells_((light.width + side_ - 1) / side_, (light.height + side_ - 1) / side_) {
        for (int y = 0; y < cells_.height; ++y) {
            for (int x = 0; x < cells_.width; ++x) {
                cells_.at(x, y) = parted(x, y);
            }
        }
    }

    Image run() {
        find_reaches();
        CellGrid blurred = cells_;
        for_each([&](int x, int y) {
            gather_near(x, y, blurred.at(x, y));
            gather_rest(x, y, blurred.at(x, y));
        });
        CellGrid filled = blurred;
        for_each([&](int x, int y) { fill(blurred, x, y, filled.at(x, y)); });
        Image out = light_;
        for (int y = 0; y < out.height; ++y) {
            for (int x = 0; x < out.width; ++x) {
                out.at(x, y) = laid_over(filled, x, y);
            }
        }
        return out;
    }

  private:
    template <class Use>
    void for_each(Use use) const {
        for (int y = 0; y < cells_.height; ++y) {
            for (int x = 0; x < cells_.width; ++x) {
                use(x, y);
            }
        }
    }

    double radius_at(int x, int y) const {
        return radii_[static_cast<std::size_t>(y) * static_cast<std::size_t>(light_.width) +
                      static_cast<std::size_t>(x)];
    }

    Cell parted(int cell_x, int cell_y) const {
        Cell out;
        double weights = 0, radii = 0, shares = 0, near_radii = 0;
        for (int i = 0; i < side_ * side_; ++i) {
            const int x = std::min(side_ * cell_x + i % side_, light_.width - 1),
                      y = std::min(side_ * cell_y + i / side_, light_.height - 1);
            const double radius = radius_at(x, y), share = before_share(radius);
            const double weight = (1 - share) * std::max(behind_share(radius), 1e-5);
            out.rest = out.rest + light_.at(x, y) * weight;
            radii += weight * std::max(radius, 0.0);
            weights += weight;
            out.near = out.near + light_.at(x, y) * share;
            near_radii -= share * radius;
            shares += share;
        }
        const bool is_known = weights > 1e-6;
        out.rest = is_known ? out.rest * (1 / weights) : RgbD{};
        out.radius = is_known ? radii / weights * texel_ : -1;
        out.near = out.near * (texel_ * texel_);
        out.opacity = shares * texel_ * texel_;
        out.near_radius = shares > 0 ? near_radii / shares * texel_ : 0;
        return out;
    }

    /// For each tile how far what is before the focus reaches into it.
    void find_reaches() {
        columns_ = (cells_.width + tile - 1) / tile;
        const int lines = (cells_.height + tile - 1) / tile;
        std::vector<double> largest(static_cast<std::size_t>(columns_ * lines), 0);
        for_each([&](int x, int y) {
            double& most = largest[tile_of(x, y)];
            most = std::max(most, cells_.at(x, y).near_radius);
        });
        reaches_.assign(largest.size(), 0);
        const int about = static_cast<int>(std::ceil(largest_ / tile));
        for (int y = 0; y < lines; ++y) {
            for (int x = 0; x < columns_; ++x) {
                for (int to_y = std::max(y - about, 0); to_y <= std::min(y + about, lines - 1);
                     ++to_y) {
                    for (int to_x = std::max(x - about, 0);
                         to_x <= std::min(x + about, columns_ - 1); ++to_x) {
                        const int apart = std::max(std::abs(to_x - x), std::abs(to_y - y));
                        const double radius =
                            largest[static_cast<std::size_t>(to_y * columns_ + to_x)];
                        if (radius + 0.5 > tile * std::max(apart - 1, 0)) {
                            double& reach = reaches_[static_cast<std::size_t>(y * columns_ + x)];
                            reach = std::max(reach, radius);
                        }
                    }
                }
            }
        }
    }

    std::size_t tile_of(int x, int y) const {
        return static_cast<std::size_t>(y / tile * columns_ + x / tile);
    }

    const Cell& at_point(int x, int y, double reach, const Point& point) const {
        return cells_.clamped(x + static_cast<int>(std::floor(point.x * reach + 0.5)),
                              y + static_cast<int>(std::floor(point.y * reach + 0.5)));
    }

    void gather_near(int x, int y, Cell& out) const {
        out.near = {};
        out.opacity = 0;
        const double reach = reaches_[tile_of(x, y)];
        if (reach <= 0) {
            return;
        }
        for (const Point& point : disc_) {
            const Cell& other = at_point(x, y, reach, point);
            const double weight = covers(other.near_radius, point.distance * reach);
            if (other.near_radius <= 0 || weight <= 0) {
                continue;
            }
            double all = 0;
            for (const Point& any : disc_) {
                all += covers(other.near_radius, any.distance * reach);
            }
            out.near = out.near + other.near * (weight / all);
            out.opacity += other.opacity * weight / all;
        }
    }

    /// After gather_near().
    void gather_rest(int x, int y, Cell& out) const {
        const Cell& own = cells_.at(x, y);
        const bool is_hidden = own.radius < 0;
        if (is_hidden && out.opacity >= 0.98) {
            out.rest = out.near * (1 / out.opacity);
            out.radius = 0;
            return;
        }
        if (!is_hidden && own.radius < 0.5 * texel_) {
            return; // as sharp as it is
        }
        const double reach = is_hidden ? 1.5 * own.near_radius + 1 : own.radius;
        RgbD sum{};
        double weights = 0;
        for (const Point& point : disc_) {
            const Cell& other = at_point(x, y, reach, point);
            if (other.radius < 0) {
                continue;
            }
            const double distance = point.distance * reach;
            const double weight = is_hidden
                                      ? 1 / (1 + distance * distance)
                                      : covers(std::min(own.radius, other.radius), distance) /
                                            std::max(other.radius * other.radius, texel_ * texel_);
            sum = sum + other.rest * weight;
            weights += weight;
        }
        if (weights > 0) {
            out.rest = sum * (1 / weights);
            out.radius = is_hidden ? 0 : own.radius;
        }
    }

    /// A tent of three by three cells, as far apart as two points of a disc of three rings.
    void fill(const CellGrid& from, int x, int y, Cell& out) const {
        const auto step_of = [](double radius) { return static_cast<int>(radius / 7 + 0.5); };
        const Cell& own = from.at(x, y);
        if (const int step = step_of(own.radius); step > 0) {
            RgbD sum{};
            double weights = 0;
            about(from, x, y, step, [&](const Cell& other, double tent) {
                const double alike =
                    &other == &own
                        ? 1
                        : std::clamp(2 - 2 * std::abs(other.radius - own.radius) / own.radius, 0.0,
                                     1.0);
                sum = sum + other.rest * (tent * alike);
                weights += tent * alike;
            });
            out.rest = sum * (1 / weights);
        }
        if (const int step = step_of(reaches_[tile_of(x, y)]); step > 0) {
            out.near = {};
            out.opacity = 0;
            about(from, x, y, step, [&](const Cell& other, double tent) {
                out.near = out.near + other.near * (tent / 16);
                out.opacity += other.opacity * tent / 16;
            });
        }
    }

    template <class Use>
    static void about(const CellGrid& from, int x, int y, int step, Use use) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                use(from.clamped(x + dx * step, y + dy * step),
                    (2 - std::abs(dx)) * (2 - std::abs(dy)));
            }
        }
    }

    RgbD laid_over(const CellGrid& filled, int x, int y) const {
        const double radius = radius_at(x, y);
        const double column = (x + 0.5) * texel_ - 0.5, row = (y + 0.5) * texel_ - 0.5;
        const int left = static_cast<int>(std::floor(column)),
                  top = static_cast<int>(std::floor(row));
        RgbD rest{}, near{};
        double weights = 0, opacity = 0;
        for (int i = 0; i < 4; ++i) {
            const Cell& cell = filled.clamped(left + i % 2, top + i / 2);
            const double share =
                (1 - std::abs(column - left - i % 2)) * (1 - std::abs(row - top - i / 2));
            near = near + cell.near * share;
            opacity += cell.opacity * share;
            if (cell.radius >= 0) {
                const double weight =
                    share * (radius > 0 ? 1e-5 + std::min(cell.radius, texel_) : 1);
                rest = rest + cell.rest * weight;
                weights += weight;
            }
        }
        RgbD color = light_.at(x, y);
        const double blur = std::max(behind_share(radius), before_share(radius));
        const bool is_known = blur <= 0 || weights > 0;
        if (blur > 0 && is_known) {
            color = color * (1 - blur) + rest * (blur / weights);
        }
        if (opacity <= 0) {
            return color;
        }
        const double over = is_known ? std::min(opacity, 1.0) : 1;
        return color * (1 - over) + near * (over / opacity);
    }

    const Image& light_;
    const std::vector<double>& radii_;
    int side_;
    double texel_;   ///< in cells
    double largest_; ///< radius, in cells
    std::vector<Point> disc_;
    CellGrid cells_;
    int columns_ = 0; ///< of tiles
    std::vector<double> reaches_;
};

} // namespace

Image focused_by_cells(const Image& light, const std::vector<double>& radii, const CellBlur& blur) {
    return Blur(light, radii, blur).run();
}

} // namespace preview::reference
