#include "preview/report/errors.h"

#include "lutlib/metrics/viewing.h"

#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <vector>

namespace preview::report {

namespace {

using lutlib::RgbD;
using reference::Image;

double square(RgbD c) {
    return c.r * c.r + c.g * c.g + c.b * c.b;
}

double relative_l2(const Image& got, const Image& wanted) {
    double apart = 0, all = 0;
    for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
        apart += square(got.pixels[i] - wanted.pixels[i]);
        all += square(wanted.pixels[i]);
    }
    return all > 0 ? std::sqrt(apart / all) : std::sqrt(apart);
}

RgbD sum_of(const Image& image) {
    RgbD out;
    for (const RgbD& pixel : image.pixels) {
        out = out + pixel;
    }
    return out;
}

struct Point {
    double x = 0, y = 0;
};

/// Of all light, in texels; the middle of the picture where there is none.
Point centroid(const Image& image) {
    double x = 0, y = 0, all = 0;
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const RgbD& light = image.at(column, row);
            const double sum = light.r + light.g + light.b;
            x += sum * column;
            y += sum * row;
            all += sum;
        }
    }
    return all > 0 ? Point{x / all, y / all} : Point{0.5 * image.width, 0.5 * image.height};
}

} // namespace

double asymmetry(const Image& image, Size centre) {
    struct Ring {
        double count = 0, r = 0, r2 = 0, light = 0, light2 = 0, both = 0;

        /// What a straight line over the radius leaves of the squares.
        double rest() const {
            if (count == 0) {
                return 0;
            }
            const double spread = r2 - r * r / count, along = both - r * light / count;
            return light2 - light * light / count - (spread > 1e-9 ? along * along / spread : 0);
        }
    };
    const int cx = static_cast<int>(centre.width), cy = static_cast<int>(centre.height);
    // Whole rings only, and texels of one ring are within half a texel of its radius.
    const int most = std::min({cx, cy, image.width - 1 - cx, image.height - 1 - cy});
    std::vector<Ring> rings(static_cast<std::size_t>(std::max(most, 0)) + 1);
    double all = 0;
    for (int y = cy - most; y <= cy + most; ++y) {
        for (int x = cx - most; x <= cx + most; ++x) {
            const double radius = std::hypot(x - cx, y - cy);
            const auto place = static_cast<std::size_t>(std::lround(radius));
            if (place < rings.size()) {
                const double light = image.at(x, y).g;
                Ring& ring = rings[place];
                ring.count += 1;
                ring.r += radius;
                ring.r2 += radius * radius;
                ring.light += light;
                ring.light2 += light * light;
                ring.both += radius * light;
                all += light * light;
            }
        }
    }
    double apart = 0;
    for (const Ring& ring : rings) {
        apart += ring.rest();
    }
    return all > 0 ? std::sqrt(std::max(apart, 0.0) / all) : 0;
}

PassError pass_error(const Image& got, const Image& wanted, std::optional<Size> impulse) {
    PassError out;
    out.relative_l2 = relative_l2(got, wanted);
    const RgbD has = sum_of(got), should = sum_of(wanted);
    for (std::size_t c = 0; c < 3; ++c) {
        const double drift = should[c] != 0 ? (has[c] - should[c]) / std::abs(should[c]) : 0;
        out.drift = std::abs(drift) > std::abs(out.drift) ? drift : out.drift;
    }
    if (impulse) {
        out.asymmetry = asymmetry(got, *impulse);
        const Point is = centroid(got), was = centroid(wanted);
        out.centroid_shift = std::hypot(is.x - was.x, is.y - was.y);
    }
    return out;
}

PictureError picture_error(const Image& got, const Image& wanted) {
    PictureError out;
    out.relative_l2 = relative_l2(got, wanted);
    for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
        const RgbD apart = got.pixels[i] - wanted.pixels[i];
        out.largest =
            std::max({out.largest, std::abs(apart.r), std::abs(apart.g), std::abs(apart.b)});
    }
    std::vector<double> cie(wanted.pixels.size()), itp(wanted.pixels.size());
    const lutlib::Eye eye{lutlib::Viewing()};
    constexpr std::size_t grain = 4096;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cie.size(), grain), [&](const auto& part) {
        const auto of = [&](auto& all) {
            return std::span(all).subspan(part.begin(), part.size());
        };
        eye.both(of(got.pixels), of(wanted.pixels), of(cie), of(itp));
    });
    out.delta_e_2000 = lutlib::error_stats(std::move(cie));
    out.delta_e_itp = lutlib::error_stats(std::move(itp));
    return out;
}

double unrest(std::span<const Image> frames, int step) {
    if (frames.size() < 2) {
        return 0;
    }
    const auto count = static_cast<int>(frames.size());
    const int width = frames.front().width, height = frames.front().height;
    const int hidden = step * (count - 1);
    double varied = 0, all = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = hidden; x < width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0, squares = 0;
                for (int k = 0; k < count; ++k) {
                    const double light = frames[static_cast<std::size_t>(k)].at(x - k * step, y)[c];
                    sum += light;
                    squares += light * light;
                }
                varied += std::max(squares - sum * sum / count, 0.0);
                all += squares;
            }
        }
    }
    return all > 0 ? std::sqrt(varied / all) : 0;
}

double unrest_of_error(std::span<const Image> got, std::span<const Image> wanted) {
    const auto count = static_cast<double>(got.size());
    double varied = 0, all = 0;
    for (std::size_t i = 0; i < got.front().pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0, squares = 0;
            for (std::size_t k = 0; k < got.size(); ++k) {
                const double is = wanted[k].pixels[i][c], error = got[k].pixels[i][c] - is;
                sum += error;
                squares += error * error;
                all += is * is;
            }
            varied += std::max(squares - sum * sum / count, 0.0);
        }
    }
    return all > 0 ? std::sqrt(varied / all) : 0;
}

Image averaged(const Image& large, int times) {
    Image out(large.width / times, large.height / times);
    const double share = 1.0 / (times * times);
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            RgbD sum;
            for (int v = 0; v < times; ++v) {
                for (int u = 0; u < times; ++u) {
                    sum = sum + large.at(x * times + u, y * times + v);
                }
            }
            out.at(x, y) = sum * share;
        }
    }
    return out;
}

} // namespace preview::report
