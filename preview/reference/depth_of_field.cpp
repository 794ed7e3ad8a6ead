#include "preview/reference/depth_of_field.h"

#include "preview/reference/hash.h"

#include <tbb/parallel_for.h>

namespace preview::reference {

namespace {

using lutlib::RgbD;

/// How much of a texel at `distance` a circle of that radius covers.
double covered(double radius, double distance) {
    return std::clamp(radius - distance + 0.5, 0.0, 1.0);
}

double near_share(double radius) {
    return std::clamp(-radius - 0.5, 0.0, 1.0);
}

double far_share(double radius) {
    return std::clamp(radius - 0.5, 0.0, 1.0);
}

struct Layer {
    Image color; ///< times opacity
    std::vector<double> opacity;
};

/// Calls use(x, y, distance) for the texels about one.
template <class Use>
void about(const Image& image, int x, int y, double reach, Use use) {
    const int steps = static_cast<int>(std::ceil(reach));
    for (int dy = -steps; dy <= steps; ++dy) {
        for (int dx = -steps; dx <= steps; ++dx) {
            const bool is_inside =
                x + dx >= 0 && y + dy >= 0 && x + dx < image.width && y + dy < image.height;
            use(x + dx, y + dy, std::hypot(dx, dy), is_inside);
        }
    }
}

std::size_t index_of(const Image& image, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(x);
}

Layer spread(const Image& light, const std::vector<double>& radii) {
    Layer out{Image(light.width, light.height), std::vector<double>(light.pixels.size())};
    for (int y = 0; y < light.height; ++y) {
        for (int x = 0; x < light.width; ++x) {
            const double radius = -radii[index_of(light, x, y)];
            const double share = near_share(-radius);
            if (share <= 0) {
                continue;
            }
            double all = 0;
            about(light, x, y, radius + 1,
                  [&](int, int, double distance, bool) { all += covered(radius, distance); });
            about(light, x, y, radius + 1, [&](int px, int py, double distance, bool is_inside) {
                if (is_inside) {
                    const double weight = share * covered(radius, distance) / all;
                    out.color.at(px, py) = out.color.at(px, py) + light.at(x, y) * weight;
                    out.opacity[index_of(light, px, py)] += weight;
                }
            });
        }
    }
    return out;
}

/// What is not before the focus, at a texel of that radius; its own colour where nothing is known.
RgbD gathered(const Image& light, const std::vector<double>& radii, int x, int y, bool& is_known) {
    const double own = radii[index_of(light, x, y)];
    const bool is_hidden = own < 0;
    RgbD sum{};
    double weights = 0;
    about(light, x, y, is_hidden ? -1.5 * own + 2 : own + 1,
          [&](int qx, int qy, double distance, bool is_inside) {
              if (!is_inside) {
                  return;
              }
              const double other = radii[index_of(light, qx, qy)];
              const double share = (1 - near_share(other)) * std::max(far_share(other), 1e-5);
              const double weight = is_hidden
                                        ? 1 / (1 + distance * distance / 4)
                                        : covered(std::min(own, std::max(other, 0.0)), distance) /
                                              std::max(other * other, 1.0);
              sum = sum + light.at(qx, qy) * (share * weight);
              weights += share * weight;
          });
    is_known = weights > 1e-9;
    return is_known ? sum * (1 / weights) : light.at(x, y);
}

} // namespace

double circle_radius(const ThinLens& lens, double z, int rows) {
    const double on_sensor =
        lens.focal / lens.aperture * lens.focal / (lens.focus - lens.focal) * (1 - lens.focus / z);
    return std::clamp(on_sensor / lens.sensor * rows / 2, -lens.largest, lens.largest);
}

Image focused(const Image& light, const std::vector<double>& radii) {
    const Layer before = spread(light, radii);
    Image out = light;
    tbb::parallel_for(0, light.height, [&](int y) {
        for (int x = 0; x < light.width; ++x) {
            const std::size_t at = index_of(light, x, y);
            const double blur = std::max(near_share(radii[at]), far_share(radii[at]));
            bool is_known = true;
            if (blur > 0) {
                const RgbD behind = gathered(light, radii, x, y, is_known);
                out.at(x, y) = mixed(light.at(x, y), behind, is_known ? blur : 0);
            }
            const double all = before.opacity[at];
            if (all > 0) {
                const double opacity = is_known ? std::min(all, 1.0) : 1;
                out.at(x, y) = mixed(out.at(x, y), before.color.at(x, y) * (1 / all), opacity);
            }
        }
    });
    return out;
}

} // namespace preview::reference
