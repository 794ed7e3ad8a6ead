// Looks that make a layout hard to tell, and what lossy formats do to a picture.
#pragma once

#include "lutlib/engine/layout.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace lutlib {

struct RudeLook {
    std::string name;
    std::function<RgbD(RgbD)> f;
    bool has_hues = true; ///< and so an order of hues to tell its layout by
};

inline double mean_of(RgbD c) {
    return (c.r + c.g + c.b) / 3;
}

/// Around the grey axis of Rec.709 luma in the plane of its colour differences, clamped.
inline RgbD turned_at_equal_luma(RgbD c, double degrees) {
    const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
    const double cb = (c.b - y) / 1.8556, cr = (c.r - y) / 1.5748;
    const double t = degrees * std::numbers::pi / 180;
    const double b = std::cos(t) * cb - std::sin(t) * cr, r = std::sin(t) * cb + std::cos(t) * cr;
    const RgbD out{y + 1.5748 * r, y - 0.1873 * b - 0.4681 * r, y + 1.8556 * b};
    return saturate(out);
}

/// The hue of HSV.
inline RgbD turned_in_hsv(RgbD c, double degrees) {
    const double high = std::max({c.r, c.g, c.b}), low = std::min({c.r, c.g, c.b});
    const double span = high - low;
    if (span <= 0) {
        return c;
    }
    const double sector = high == c.r   ? (c.g - c.b) / span
                          : high == c.g ? 2 + (c.b - c.r) / span
                                        : 4 + (c.r - c.g) / span;
    const auto channel = [&](double n) {
        const double k = std::fmod(n + sector + degrees / 60 + 12, 6.0);
        return high - span * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    };
    return {channel(5), channel(3), channel(1)};
}

/// In 0..1, evenly spread, of the colour and a seed alone: looks are sampled by several threads, in
/// no order (splitmix64's finisher).
inline double noise_of(RgbD c, std::uint64_t seed) {
    std::uint64_t h = seed;
    for (const double v : {c.r, c.g, c.b}) {
        h += std::bit_cast<std::uint64_t>(v) + 0x9e3779b97f4a7c15u;
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
        h ^= h >> 31;
    }
    return static_cast<double>(h >> 11) * 0x1p-53;
}

inline std::vector<RudeLook> rude_looks() {
    const auto grey = [](double r, double g, double b) {
        return [=](RgbD c) {
            const double y = std::clamp(r * c.r + g * c.g + b * c.b, 0.0, 1.0);
            return RgbD{y, y, y};
        };
    };
    std::vector<RudeLook> out{
        {"identity", [](RgbD c) { return c; }},
        {"negative",
         [](RgbD c) {
             return RgbD{1 - c.r, 1 - c.g, 1 - c.b};
         }},
        {"black and white", grey(0.2126, 0.7152, 0.0722), false},
        {"black and white by the mean", grey(1.0 / 3, 1.0 / 3, 1.0 / 3), false},
        {"black and white by red", grey(1, 0, 0), false},
        {"black and white by green", grey(0, 1, 0), false},
        {"black and white by blue", grey(0, 0, 1), false},
        {"black and white, red filter", grey(1.4, -0.3, -0.1), false},
        {"black and white, blue filter", grey(-0.3, 0.3, 1.0), false},
        {"black and white, green taken away", grey(0.9, -0.3, 0.4), false},
        {"black and white negative",
         [](RgbD c) {
             const double y = 1 - (0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b);
             return RgbD{y, y, y};
         },
         false},
        {"sepia",
         [](RgbD c) {
             const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
             return saturate(RgbD{1.1 * y, 0.9 * y, 0.65 * y});
         },
         false},
        {"duotone",
         [](RgbD c) {
             const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
             return RgbD{0.1 + 0.9 * y * y, 0.05 + 0.7 * y, 0.35 + 0.3 * y};
         },
         false},
        {"false colours",
         [](RgbD c) {
             const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
             const auto hump = [y](double at) { return std::exp(-25 * (y - at) * (y - at)); };
             return RgbD{hump(0.9), hump(0.5), hump(0.15)};
         },
         false},
        {"solarised",
         [](RgbD c) {
             const auto s = [](double x) { return x < 0.5 ? 2 * x : 2 - 2 * x; };
             return RgbD{s(c.r), s(c.g), s(c.b)};
         },
         false},
        {"nearly grey",
         [](RgbD c) {
             const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
             return RgbD{0.92 * y + 0.08 * c.r, 0.92 * y + 0.08 * c.g, 0.92 * y + 0.08 * c.b};
         }},
        {"teal and orange",
         [](RgbD c) {
             const double y = mean_of(c), w = y * y * (3 - 2 * y);
             return saturate(RgbD{c.r * 0.7 + 0.35 * w - 0.05, c.g * 0.75 + 0.1 + 0.05 * w,
                                  c.b * 0.7 + 0.3 * (1 - w)});
         }},
        {"strongly tinted",
         [](RgbD c) {
             return RgbD{0.25 + 0.6 * c.r, 0.5 * c.g, 0.4 + 0.35 * c.b};
         }},
        {"crossed curves",
         [](RgbD c) {
             const auto s = [](double x) { return x * x * (3 - 2 * x); };
             return RgbD{s(s(c.r)), s(c.g), 0.2 + 0.6 * c.b};
         }},
        {"crushed",
         [](RgbD c) {
             const auto s = [](double x) { return std::clamp(6 * (x - 0.5) + 0.5, 0.0, 1.0); };
             return RgbD{s(c.r), s(c.g), s(c.b)};
         }},
        {"posterised",
         [](RgbD c) {
             const auto s = [](double x) { return std::floor(x * 3.999) / 3; };
             return RgbD{s(c.r), s(c.g), s(c.b)};
         }},
        {"over-saturated",
         [](RgbD c) {
             const double y = mean_of(c);
             return saturate(RgbD{y + 3 * (c.r - y), y + 3 * (c.g - y), y + 3 * (c.b - y)});
         }},
        {"only reds kept",
         [](RgbD c) {
             const double y = mean_of(c);
             const double keep = std::clamp(3 * (c.r - std::max(c.g, c.b)), 0.0, 1.0);
             return RgbD{y + keep * (c.r - y), y + keep * (c.g - y), y + keep * (c.b - y)};
         }},
        {"mixed channels",
         [](RgbD c) {
             return saturate(RgbD{0.5 * c.r + 0.5 * c.g, 0.2 * c.r + 0.5 * c.g + 0.3 * c.b,
                                  0.6 * c.b + 0.4 * c.g});
         }},
        {"constant",
         [](RgbD) {
             return RgbD{0.4, 0.5, 0.6};
         },
         false},
        {"noise",
         [](RgbD c) {
             return RgbD{noise_of(c, 1), noise_of(c, 2), noise_of(c, 3)};
         },
         false},
        {"noisy identity",
         [](RgbD c) {
             const auto some = [&](std::uint64_t seed) {
                 return 0.14 * (noise_of(c, seed) - 0.5);
             };
             return saturate(RgbD{c.r + some(4), c.g + some(5), c.b + some(6)});
         }},
    };
    for (int degrees = 30; degrees < 360; degrees += 30) {
        out.push_back({"turned by " + std::to_string(degrees) + " at equal luma",
                       [=](RgbD c) { return turned_at_equal_luma(c, degrees); }});
        out.push_back({"turned by " + std::to_string(degrees) + " in HSV",
                       [=](RgbD c) { return turned_in_hsv(c, degrees); }});
    }
    return out;
}

/// What JPEG does: Y'CbCr of BT.601, colour at half resolution, blocks of 8 x 8 transformed by the
/// DCT and quantised by the tables of ITU-T T.81 annex K, scaled as libjpeg scales them.
inline Picture jpeg_compressed(const Picture& picture, int quality) {
    static constexpr std::array<int, 64> luma_steps{
        16, 11, 10, 16, 24,  40,  51,  61,  12, 12, 14, 19, 26,  58,  60,  55,
        14, 13, 16, 24, 40,  57,  69,  56,  14, 17, 22, 29, 51,  87,  80,  62,
        18, 22, 37, 56, 68,  109, 103, 77,  24, 35, 55, 64, 81,  104, 113, 92,
        49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99};
    static constexpr std::array<int, 64> chroma_steps{
        17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99,
        99, 99, 47, 66, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
        99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99};
    const int percent = quality < 50 ? 5000 / quality : 200 - 2 * quality;
    const auto basis = [] {
        std::array<std::array<double, 8>, 8> out{};
        for (std::size_t k = 0; k < 8; ++k) {
            for (std::size_t x = 0; x < 8; ++x) {
                out[k][x] = (k == 0 ? std::sqrt(0.125) : 0.5) *
                            std::cos((2 * static_cast<double>(x) + 1) * static_cast<double>(k) *
                                     std::numbers::pi / 16);
            }
        }
        return out;
    }();
    struct Plane {
        int width, height;
        std::vector<double> values;
        double& at(int x, int y) {
            return values[static_cast<std::size_t>(std::min(y, height - 1) * width +
                                                   std::min(x, width - 1))];
        }
    };
    // Rows of the block (or columns, with the steps exchanged) through the basis or its inverse.
    const auto transform = [&](std::array<double, 64>& block, std::size_t along, std::size_t across,
                               bool inverse) {
        for (std::size_t line = 0; line < 8; ++line) {
            std::array<double, 8> out{};
            for (std::size_t k = 0; k < 8; ++k) {
                for (std::size_t x = 0; x < 8; ++x) {
                    out[k] +=
                        (inverse ? basis[x][k] : basis[k][x]) * block[line * across + x * along];
                }
            }
            for (std::size_t k = 0; k < 8; ++k) {
                block[line * across + k * along] = out[k];
            }
        }
    };
    const auto quantise = [&](Plane& plane, const std::array<int, 64>& steps) {
        for (int by = 0; by < plane.height; by += 8) {
            for (int bx = 0; bx < plane.width; bx += 8) {
                std::array<double, 64> block{};
                for (std::size_t i = 0; i < 64; ++i) {
                    block[i] = plane.at(bx + static_cast<int>(i % 8), by + static_cast<int>(i / 8));
                }
                transform(block, 1, 8, false);
                transform(block, 8, 1, false);
                for (std::size_t i = 0; i < 64; ++i) {
                    const double step = std::clamp((steps[i] * percent + 50) / 100, 1, 255);
                    block[i] = std::round(block[i] / step) * step;
                }
                transform(block, 1, 8, true);
                transform(block, 8, 1, true);
                for (std::size_t i = 0; i < 64; ++i) {
                    const int x = bx + static_cast<int>(i % 8), y = by + static_cast<int>(i / 8);
                    if (x < plane.width && y < plane.height) {
                        plane.at(x, y) = block[i];
                    }
                }
            }
        }
    };
    const auto plane = [](int width, int height) {
        return Plane{width, height,
                     std::vector<double>(static_cast<std::size_t>(width) *
                                         static_cast<std::size_t>(height))};
    };
    const int half_width = (picture.width + 1) / 2, half_height = (picture.height + 1) / 2;
    Plane luma = plane(picture.width, picture.height);
    Plane cb = plane(half_width, half_height), cr = cb;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const RgbD c = to_double(picture.at(x, y)) * 255.0;
            luma.at(x, y) = 0.299 * c.r + 0.587 * c.g + 0.114 * c.b - 128;
            cb.at(x / 2, y / 2) += (-0.168736 * c.r - 0.331264 * c.g + 0.5 * c.b) / 4;
            cr.at(x / 2, y / 2) += (0.5 * c.r - 0.418688 * c.g - 0.081312 * c.b) / 4;
        }
    }
    quantise(luma, luma_steps);
    quantise(cb, chroma_steps);
    quantise(cr, chroma_steps);
    Picture out = picture;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double l = luma.at(x, y) + 128, b = cb.at(x / 2, y / 2), r = cr.at(x / 2, y / 2);
            const RgbD c{l + 1.402 * r, l - 0.344136 * b - 0.714136 * r, l + 1.772 * b};
            for (std::size_t i = 0; i < 3; ++i) {
                out.at(x, y)[i] =
                    static_cast<float>(std::round(std::clamp(c[i], 0.0, 255.0)) / 255);
            }
        }
    }
    return out;
}

} // namespace lutlib
