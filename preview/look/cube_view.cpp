#include "preview/look/cube_view.h"

#include "lutlib/codes.h"
#include "lutlib/interpolation/interpolation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace preview {

namespace {

using lutlib::Rgb;

struct Seen {
    float x, y;
    float depth; ///< grows away from the eye, about 0
    float size;  ///< by perspective, about 1
};

class Camera {
  public:
    Camera(const CubeView& view, float width, float height)
        : x_(width / 2), y_(height / 2), scale_(view.zoom * std::min(width, height) / 2.2F) {
        constexpr float degree = std::numbers::pi_v<float> / 180;
        turn_cos_ = std::cos(view.turn * degree);
        turn_sin_ = std::sin(view.turn * degree);
        tilt_cos_ = std::cos(view.tilt * degree);
        tilt_sin_ = std::sin(view.tilt * degree);
    }

    Seen see(Rgb c) const {
        // Along red, along green against blue, and up the neutral axis.
        const float red = (2 * c.r - c.g - c.b) / std::sqrt(6.0F);
        const float green = (c.g - c.b) / std::sqrt(2.0F);
        const float up = (c.r + c.g + c.b - 1.5F) / std::sqrt(3.0F);
        const float right = red * turn_cos_ + green * turn_sin_;
        const float away = green * turn_cos_ - red * turn_sin_;
        const float depth = away * tilt_cos_ - up * tilt_sin_;
        const float size = 1 / std::max(1 + 0.22F * depth, 0.1F);
        return {x_ + scale_ * size * right,
                y_ - scale_ * size * (up * tilt_cos_ + away * tilt_sin_), depth, size};
    }
    float scale() const { return scale_; }
    void shrink(float share) { scale_ *= share; }

  private:
    float x_, y_, scale_, turn_cos_ = 1, turn_sin_ = 0, tilt_cos_ = 1, tilt_sin_ = 0;
};

Rgb8 codes(Rgb color) {
    const auto code = [](float value) {
        return static_cast<std::uint8_t>(lutlib::CodeDepth{8}.code(value));
    };
    return {code(color.r), code(color.g), code(color.b)};
}

CubeLine line(const Camera& camera, Rgb from, Rgb to, float width, float opacity, Rgb8 color) {
    const Seen a = camera.see(from), b = camera.see(to);
    return {a.x, a.y, b.x, b.y, width, opacity, color};
}

bool is_finite(Rgb c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

Rgb corner(unsigned bits) {
    return {static_cast<float>(bits & 1), static_cast<float>(bits >> 1 & 1),
            static_cast<float>(bits >> 2 & 1)};
}

Rgb placed(Rgb output, const CubeView& view) {
    return view.clamped ? lutlib::saturate(output) : output;
}

void draw_edges(const Camera& camera, CubeDrawing& drawing) {
    constexpr Rgb8 grey{150, 150, 158};
    unsigned farthest = 0;
    for (unsigned bits = 1; bits < 8; ++bits) {
        if (camera.see(corner(bits)).depth > camera.see(corner(farthest)).depth) {
            farthest = bits;
        }
    }
    for (unsigned bits = 0; bits < 8; ++bits) {
        for (const unsigned axis : {1U, 2U, 4U}) {
            if ((bits & axis) != 0) {
                continue;
            }
            const bool hidden = bits == farthest || (bits | axis) == farthest;
            (hidden ? drawing.behind : drawing.before)
                .push_back(line(camera, corner(bits), corner(bits | axis), 1.2F,
                                hidden ? 0.35F : 0.7F, grey));
        }
    }
    drawing.behind.push_back(line(camera, corner(0), corner(7), 1, 0.6F, {230, 230, 230}));
}

void draw_neutrals(const Camera& camera, const NodeCloud& nodes, const CubeView& view,
                   CubeDrawing& drawing) {
    const std::size_t n = nodes.per_side(), diagonal = 1 + n + n * n;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const Rgb from = nodes.outputs[i * diagonal], to = nodes.outputs[(i + 1) * diagonal];
        if (is_finite(from) && is_finite(to)) {
            drawing.before.push_back(
                line(camera, placed(from, view), placed(to, view), 2, 0.95F, {255, 255, 255}));
        }
    }
}

/// By how much the cube is drawn smaller so that the dots of a look that leaves it stay in the
/// picture, from whatever side they are seen.
float fitting_share(const NodeCloud& nodes, const CubeView& view) {
    // As far as a point may be seen from the middle, brought near by the perspective.
    const auto reach = [](float radius) { return radius / std::max(1 - 0.22F * radius, 0.1F); };
    const float corner_radius = std::sqrt(0.75F);
    float radius = corner_radius;
    for (const Rgb& output : nodes.outputs) {
        if (is_finite(output)) {
            const Rgb c = placed(output, view);
            radius = std::max(radius, std::hypot(c.r - 0.5F, c.g - 0.5F, c.b - 0.5F));
        }
    }
    return std::max(reach(corner_radius) / reach(radius), 0.02F);
}

/// R, G and B beside the corners where that channel alone is 1.
void draw_names(const Camera& camera, CubeDrawing& drawing) {
    using Stroke = std::array<float, 4>; // x0, y0, x1, y1 within 0..1 from the upper left
    static constexpr std::array<Stroke, 5> r{{{0, 0, 0, 1},
                                              {0, 0, 0.7F, 0},
                                              {0.7F, 0, 0.7F, 0.5F},
                                              {0.7F, 0.5F, 0, 0.5F},
                                              {0.2F, 0.5F, 0.7F, 1}}};
    static constexpr std::array<Stroke, 5> g{{{0.7F, 0, 0, 0},
                                              {0, 0, 0, 1},
                                              {0, 1, 0.7F, 1},
                                              {0.7F, 1, 0.7F, 0.5F},
                                              {0.7F, 0.5F, 0.4F, 0.5F}}};
    static constexpr std::array<Stroke, 6> b{{{0, 0, 0, 1},
                                              {0, 0, 0.6F, 0},
                                              {0.6F, 0, 0.6F, 0.5F},
                                              {0, 0.5F, 0.7F, 0.5F},
                                              {0.7F, 0.5F, 0.7F, 1},
                                              {0.7F, 1, 0, 1}}};
    const auto draw = [&](std::span<const Stroke> strokes, Rgb at, Rgb8 color) {
        const float size = std::max(0.05F * camera.scale(), 6.0F);
        const Seen middle = camera.see({0.5F, 0.5F, 0.5F}), seen = camera.see(at);
        const float dx = seen.x - middle.x, dy = seen.y - middle.y;
        const float away = 1.3F * size / std::max(std::hypot(dx, dy), 1.0F);
        const float x = seen.x + dx * away - 0.35F * size, y = seen.y + dy * away - 0.5F * size;
        for (const Stroke& s : strokes) {
            drawing.before.push_back({x + size * s[0], y + size * s[1], x + size * s[2],
                                      y + size * s[3], 1.5F, 1, color});
        }
    };
    draw(r, {1, 0, 0}, {255, 110, 100});
    draw(g, {0, 1, 0}, {110, 220, 110});
    draw(b, {0, 0, 1}, {120, 150, 255});
}

struct DepthDot {
    float depth;
    CubeDot dot;
};

void draw_nodes(const Camera& camera, const NodeCloud& nodes, const CubeView& view,
                CubeDrawing& drawing) {
    const std::size_t n = nodes.per_side();
    const float radius =
        std::clamp(0.24F * camera.scale() / static_cast<float>(n), 1.0F, 0.02F * camera.scale());
    std::vector<DepthDot> sorted;
    sorted.reserve(nodes.outputs.size());
    for (std::size_t i = 0; i < nodes.outputs.size(); ++i) {
        if (!is_finite(nodes.outputs[i])) {
            continue;
        }
        const Rgb out = placed(nodes.outputs[i], view);
        const Rgb in{nodes.inputs[i % n], nodes.inputs[i / n % n], nodes.inputs[i / (n * n)]};
        const Seen seen = camera.see(out);
        sorted.push_back(
            {seen.depth, {seen.x, seen.y, radius * seen.size, codes(view.by_input ? in : out)}});
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const DepthDot& a, const DepthDot& b) { return a.depth > b.depth; });
    for (const DepthDot& dot : sorted) {
        drawing.dots.push_back(dot.dot);
    }
}

/// What the drawing is put on, pixel by pixel.
class Canvas {
  public:
    Canvas(int width, int height)
        : width_(width), height_(height), pixels_(std::size_t{4} * static_cast<std::size_t>(width) *
                                                  static_cast<std::size_t>(height)) {
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            pixels_[i] = i % 4 < 3 ? cube_ground[i % 4] : std::uint8_t{255};
        }
    }

    /// Blends `color` over every pixel within the box by `coverage` of its middle.
    template <class Coverage>
    void paint(float left, float top, float right, float bottom, Rgb8 color, Coverage coverage) {
        const int x0 = bounded(std::floor(left), width_), x1 = bounded(std::ceil(right), width_);
        const int y0 = bounded(std::floor(top), height_), y1 = bounded(std::ceil(bottom), height_);
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) {
                const float share =
                    std::clamp(coverage(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F),
                               0.0F, 1.0F);
                std::uint8_t* const pixel =
                    &pixels_[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                  static_cast<std::size_t>(x))];
                for (std::size_t c = 0; c < 3; ++c) {
                    pixel[c] = static_cast<std::uint8_t>(
                        std::lround(static_cast<float>(pixel[c]) * (1 - share) +
                                    static_cast<float>(color[c]) * share));
                }
            }
        }
    }
    std::vector<std::uint8_t> take() { return std::move(pixels_); }

  private:
    static int bounded(float at, int size) {
        return static_cast<int>(std::clamp(at, 0.0F, static_cast<float>(size)));
    }
    int width_, height_;
    std::vector<std::uint8_t> pixels_;
};

void paint(Canvas& canvas, const CubeDot& dot) {
    const float reach = dot.radius + 1;
    canvas.paint(
        dot.x - reach, dot.y - reach, dot.x + reach, dot.y + reach, dot.color,
        [&](float x, float y) { return dot.radius + 0.5F - std::hypot(x - dot.x, y - dot.y); });
}

void paint(Canvas& canvas, const CubeLine& line) {
    const float dx = line.x1 - line.x0, dy = line.y1 - line.y0;
    const float squared = std::max(dx * dx + dy * dy, 1e-12F);
    const float reach = line.width + 1;
    canvas.paint(std::min(line.x0, line.x1) - reach, std::min(line.y0, line.y1) - reach,
                 std::max(line.x0, line.x1) + reach, std::max(line.y0, line.y1) + reach, line.color,
                 [&](float x, float y) {
                     const float along = std::clamp(
                         ((x - line.x0) * dx + (y - line.y0) * dy) / squared, 0.0F, 1.0F);
                     const float away =
                         std::hypot(x - line.x0 - along * dx, y - line.y0 - along * dy);
                     return line.opacity * std::clamp(line.width / 2 + 0.5F - away, 0.0F, 1.0F);
                 });
}

} // namespace

NodeCloud cube_nodes(const lutlib::Lut& look, int most) {
    NodeCloud out;
    const int size = look.cube ? look.cube->size : most;
    const int count = std::min(most, size);
    std::vector<int> chosen;
    for (int i = 0; i < count; ++i) {
        // To the nearest; 2 i (size - 1) + (count - 1) does not overflow for lattices.
        chosen.push_back((2 * i * (size - 1) + (count - 1)) / (2 * (count - 1)));
        out.inputs.push_back(static_cast<float>(chosen.back()) / static_cast<float>(size - 1));
    }
    const lutlib::Domain domain = look.cube ? lutlib::Domain{} : look.domain();
    const auto input = [&](std::size_t channel, int i) {
        const double low = static_cast<double>(domain.min[channel]);
        return low + static_cast<double>(out.inputs[static_cast<std::size_t>(i)]) *
                         (static_cast<double>(domain.max[channel]) - low);
    };
    for (int b = 0; b < count; ++b) {
        for (int g = 0; g < count; ++g) {
            for (int r = 0; r < count; ++r) {
                out.outputs.push_back(look.cube
                                          ? look.cube->at(chosen[static_cast<std::size_t>(r)],
                                                          chosen[static_cast<std::size_t>(g)],
                                                          chosen[static_cast<std::size_t>(b)])
                                          : lutlib::to_float(lutlib::evaluate_exact(
                                                look, {input(0, r), input(1, g), input(2, b)})));
            }
        }
    }
    return out;
}

void draw_cube(const NodeCloud& nodes, const CubeView& view, float width, float height,
               CubeDrawing& drawing) {
    drawing.behind.clear();
    drawing.dots.clear();
    drawing.before.clear();
    Camera camera(view, width, height);
    camera.shrink(fitting_share(nodes, view));
    draw_edges(camera, drawing);
    draw_nodes(camera, nodes, view, drawing);
    draw_neutrals(camera, nodes, view, drawing);
    draw_names(camera, drawing);
}

std::vector<std::uint8_t> rasterised(const CubeDrawing& drawing, int width, int height) {
    Canvas canvas(width, height);
    for (const CubeLine& line : drawing.behind) {
        paint(canvas, line);
    }
    for (const CubeDot& dot : drawing.dots) {
        paint(canvas, dot);
    }
    for (const CubeLine& line : drawing.before) {
        paint(canvas, line);
    }
    return canvas.take();
}

} // namespace preview
