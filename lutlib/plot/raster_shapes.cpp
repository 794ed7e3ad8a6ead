#include "lutlib/plot/raster_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace plot {
namespace {

// The pixels that a shape may touch, and how much of each it covers.
class Coverage {
  public:
    Coverage(const Raster& raster, double left, double top, double right, double bottom)
        : left_(held(std::floor(left), raster.width())),
          top_(held(std::floor(top), raster.height())),
          width_(held(std::ceil(right), raster.width()) - left_),
          height_(held(std::ceil(bottom), raster.height()) - top_),
          shares_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

    /// By a function of the distance to the shape's middle, over a part of the pixels.
    template <class Distance>
    void add(double left, double top, double right, double bottom, double reach,
             const Distance& distance) {
        const int x0 = std::max(left_, clamped(left)),
                  x1 = std::min(left_ + width_, clamped(right));
        const int y0 = std::max(top_, clamped(top)), y1 = std::min(top_ + height_, clamped(bottom));
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) {
                const double share =
                    std::clamp(reach + 0.5 - distance(Point{x + 0.5, y + 0.5}), 0.0, 1.0);
                float& here = shares_[index(x, y)];
                here = std::max(here, static_cast<float>(share));
            }
        }
    }

    void paint(Raster& raster, Rgb8 color) const {
        for (int y = top_; y < top_ + height_; ++y) {
            for (int x = left_; x < left_ + width_; ++x) {
                const float share = shares_[index(x, y)];
                if (share <= 0) {
                    continue;
                }
                Rgb8& pixel = raster.at(x, y);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double mixed = std::lerp(pixel[c], color[c], share);
                    pixel[c] = static_cast<std::uint8_t>(std::lround(mixed));
                }
            }
        }
    }

  private:
    static int held(double place, int size) {
        return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(size)));
    }
    int clamped(double place) const {
        constexpr double far = 1e9;
        return static_cast<int>(std::clamp(place, -far, far));
    }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x - left_);
    }

    int left_, top_, width_, height_;
    std::vector<float> shares_;
};

double distance_to(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y, squares = dx * dx + dy * dy;
    const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
    const double t = squares > 0 ? std::clamp(along / squares, 0.0, 1.0) : 0;
    return std::hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

Point between(Point a, Point b, double t) {
    return {std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t)};
}

} // namespace

void draw_line(Raster& raster, std::span<const Point> points, double width, Rgb8 color) {
    if (points.empty()) {
        return;
    }
    const auto [left, right] = std::minmax_element(
        points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    const auto [top, bottom] = std::minmax_element(
        points.begin(), points.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    const double reach = width / 2, margin = reach + 1;
    Coverage coverage(raster, left->x - margin, top->y - margin, right->x + margin,
                      bottom->y + margin);
    for (std::size_t i = 0; i + 1 < std::max<std::size_t>(points.size(), 2); ++i) {
        const Point a = points[i], b = points[std::min(i + 1, points.size() - 1)];
        coverage.add(std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin,
                     std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin, reach,
                     [&](Point p) { return distance_to(p, a, b); });
    }
    coverage.paint(raster, color);
}

void draw_disc(Raster& raster, Point center, double radius, Rgb8 color) {
    draw_line(raster, std::span(&center, 1), 2 * radius, color);
}

std::vector<std::vector<Point>> pieces_of(std::span<const Point> points) {
    std::vector<std::vector<Point>> out;
    bool is_open = false;
    for (const Point& p : points) {
        const bool is_place = std::isfinite(p.x) && std::isfinite(p.y);
        if (is_place && !is_open) {
            out.emplace_back();
        }
        if (is_place) {
            out.back().push_back(p);
        }
        is_open = is_place;
    }
    return out;
}

std::vector<std::vector<Point>> dashes_of(std::span<const Point> points, double on, double off) {
    std::vector<std::vector<Point>> out;
    for (const std::vector<Point>& piece : pieces_of(points)) {
        bool is_on = true;
        double left = on; // of the dash or gap
        out.push_back({piece.front()});
        for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
            const double length =
                std::hypot(piece[i + 1].x - piece[i].x, piece[i + 1].y - piece[i].y);
            double done = 0;
            while (length - done > left) {
                done += left;
                const Point border = between(piece[i], piece[i + 1], done / length);
                if (is_on) {
                    out.back().push_back(border);
                } else {
                    out.push_back({border});
                }
                is_on = !is_on;
                left = is_on ? on : off;
            }
            left -= length - done;
            if (is_on) {
                out.back().push_back(piece[i + 1]);
            }
        }
    }
    return out;
}

} // namespace plot
