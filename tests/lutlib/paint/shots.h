// Screenshots with strips in them, and what paint programs do to them.
#pragma once

#include "lutlib/paint/strip.h"
#include "lutlib/transform.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace lutlib {

/// As a picture of so many bits holds it.
inline Picture in_codes(Picture picture, int bits = 8) {
    const CodeDepth depth{bits};
    for (Rgb& c : picture.pixels) {
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] = static_cast<float>(depth.value(depth.code(static_cast<double>(c[k]))));
        }
    }
    return picture;
}

/// A picture with flat parts, gradients, edges and stripes as far apart as slices.
inline Picture screenshot(int width, int height) {
    Picture out{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double u = static_cast<double>(x) / width, v = static_cast<double>(y) / height;
            const double stripe = (x / 16) % 2 == 0 && y > height / 2 ? 0.2 : 0.0;
            const bool round = std::hypot(u - 0.6, v - 0.4) < 0.2;
            const RgbD c{0.2 + 0.5 * u + stripe, round ? 0.7 : 0.3 + 0.3 * std::sin(9 * u * v),
                         round ? 0.2 : 0.6 * v + stripe};
            out.pixels.push_back(to_float(saturate(c)));
        }
    }
    return in_codes(std::move(out));
}

inline void put(Picture& onto, const Picture& what, Pixel at) {
    for (int y = 0; y < what.height; ++y) {
        for (int x = 0; x < what.width; ++x) {
            onto.at(at.x + x, at.y + y) = what.at(x, y);
        }
    }
}

inline Picture frame_picture(const Framed& framed) {
    const CodeImage codes = neutral_frame(framed);
    Picture out{codes.width, codes.height, {}};
    for (std::size_t i = 0; i < codes.samples.size(); i += 3) {
        const auto value = [&](std::size_t c) {
            return static_cast<float>(codes.samples[i + c]) /
                   static_cast<float>(codes.depth.maximum());
        };
        out.pixels.push_back({value(0), value(1), value(2)});
    }
    return out;
}

inline Picture graded(Picture picture, const Transform& look, int bits = 8) {
    for (Rgb& c : picture.pixels) {
        c = to_float(saturate(look(to_double(c))));
    }
    return in_codes(std::move(picture), bits);
}

/// A warm grade with some contrast, of channels that mix.
inline Transform warm_look() {
    return Transform::each([](RgbD c) {
        const double grey = (c.r + c.g + c.b) / 3;
        const auto curve = [](double x) {
            const double s = saturate(x);
            return s + 0.6 * s * (1 - s) * (s - 0.5);
        };
        return saturate(RgbD{0.04 + 0.9 * curve(0.8 * c.r + 0.2 * grey),
                             0.92 * curve(0.85 * c.g + 0.15 * grey),
                             0.02 + 0.8 * curve(0.7 * c.b + 0.3 * grey)});
    });
}

inline Transform negative_look() {
    return Transform::each([](RgbD c) { return RgbD{1 - c.r, 1 - 0.8 * c.g, 0.9 - 0.9 * c.b}; });
}

/// The same on every machine, of standard deviation 1.
class Noise {
  public:
    float operator()() {
        double sum = 0;
        for (int i = 0; i < 12; ++i) {
            state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
            sum += static_cast<double>(state_ >> 11) / 9007199254740992.0;
        }
        return static_cast<float>(sum - 6);
    }

  private:
    std::uint64_t state_ = 7;
};

inline Picture noisy(Picture picture, double codes) {
    Noise noise;
    for (Rgb& c : picture.pixels) {
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] += static_cast<float>(codes / 255) * noise();
        }
    }
    return in_codes(std::move(picture));
}

/// Each pixel mixed with the four beside it: `share` of it theirs; below 0 it sharpens.
inline Picture blurred(const Picture& picture, float share) {
    Picture out = picture;
    for (int y = 1; y + 1 < picture.height; ++y) {
        for (int x = 1; x + 1 < picture.width; ++x) {
            const Rgb beside = (picture.at(x - 1, y) + picture.at(x + 1, y) + picture.at(x, y - 1) +
                                picture.at(x, y + 1)) *
                               0.25F;
            out.at(x, y) = saturate(picture.at(x, y) * (1 - share) + beside * share);
        }
    }
    return in_codes(std::move(out));
}

/// By bilinear interpolation.
inline Picture scaled(const Picture& picture, double by) {
    Picture out{static_cast<int>(picture.width * by), static_cast<int>(picture.height * by), {}};
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const double u = std::min(std::max(0.0, (x + 0.5) / by - 0.5), picture.width - 1.001),
                         v = std::min(std::max(0.0, (y + 0.5) / by - 0.5), picture.height - 1.001);
            const int i = static_cast<int>(u), k = static_cast<int>(v);
            const auto s = static_cast<float>(u - i), t = static_cast<float>(v - k);
            out.pixels.push_back((picture.at(i, k) * (1 - s) + picture.at(i + 1, k) * s) * (1 - t) +
                                 (picture.at(i, k + 1) * (1 - s) + picture.at(i + 1, k + 1) * s) *
                                     t);
        }
    }
    return in_codes(std::move(out));
}

/// The largest difference of a lattice from a look, in codes of 8 bits.
inline double off_from(const Lut3D& cube, const Transform& look) {
    double most = 0;
    for (int b = 0; b < cube.size; ++b) {
        for (int g = 0; g < cube.size; ++g) {
            for (int r = 0; r < cube.size; ++r) {
                const RgbD right = saturate(look(node_position(cube, r, g, b)));
                most = std::max(most, largest_magnitude(to_double(cube.at(r, g, b)) - right));
            }
        }
    }
    return 255 * most;
}

/// Scaled and turned clockwise about its middle, by straight lines between pixels; what lay beyond
/// it is grey.
inline Picture resampled(const Picture& picture, double scale, double degrees) {
    Picture out{
        static_cast<int>(picture.width * scale), static_cast<int>(picture.height * scale), {}};
    const double turn = degrees / 57.29577951308232, c = std::cos(turn) / scale,
                 s = std::sin(turn) / scale;
    const auto pixel = [&picture](int x, int y) {
        return x >= 0 && y >= 0 && x < picture.width && y < picture.height ? picture.at(x, y)
                                                                           : Rgb{0.5F, 0.5F, 0.5F};
    };
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const double u = x + 0.5 - out.width / 2.0, v = y + 0.5 - out.height / 2.0;
            const double from_x = c * u + s * v + picture.width / 2.0 - 0.5,
                         from_y = c * v - s * u + picture.height / 2.0 - 0.5;
            const int left = static_cast<int>(std::floor(from_x)),
                      top = static_cast<int>(std::floor(from_y));
            const auto across = static_cast<float>(from_x - left),
                       down = static_cast<float>(from_y - top);
            const Rgb above = (1 - across) * pixel(left, top) + across * pixel(left + 1, top),
                      below =
                          (1 - across) * pixel(left, top + 1) + across * pixel(left + 1, top + 1);
            out.pixels.push_back((1 - down) * above + down * below);
        }
    }
    return out;
}

} // namespace lutlib
