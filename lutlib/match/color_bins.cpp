#include "lutlib/match/color_bins.h"

#include "lutlib/color/transfer_curve.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace lutlib {
namespace {

// Of a bin, as many as tell its median.
constexpr std::size_t enough_for_median = 255;
// Deviations are counted in steps of this, up to where they are outliers anyway.
constexpr double deviation_step = 1.0 / 65536;
constexpr std::size_t deviation_steps = 1 << 14;
// The standard deviation of a normal distribution whose median deviation is 1.
constexpr double deviation_of_median = 1.4826;

std::size_t bin_of(Rgb c, int side) {
    const auto along = [side](float x) {
        return static_cast<std::size_t>(
            std::min(static_cast<int>(x * static_cast<float>(side)), side - 1));
    };
    const auto n = static_cast<std::size_t>(side);
    return along(c.r) + n * (along(c.g) + n * along(c.b));
}

bool is_finite(const PixelPair& pixel) {
    return std::isfinite(largest_magnitude(to_double(pixel.before))) &&
           std::isfinite(largest_magnitude(to_double(pixel.after)));
}

Rgb held_to_halves(Rgb c) {
    constexpr auto most = static_cast<float>(largest_light);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        c[channel] = std::clamp(c[channel], -most, most);
    }
    return c;
}

// What is used again for each bin that a thread works on.
struct Scratch {
    std::vector<RgbD> off; ///< of each pixel, from the look
    std::vector<double> channel;
};

void find_off(std::span<const PixelPair> pixels, const Transform& look, Scratch& scratch) {
    scratch.off.clear();
    for (const PixelPair& pixel : pixels) {
        scratch.off.push_back(to_double(pixel.before));
    }
    look(scratch.off);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        scratch.off[i] = to_double(pixels[i].after) - scratch.off[i];
    }
}

RgbD median_off(Scratch& scratch) {
    const std::size_t step = 1 + scratch.off.size() / enough_for_median;
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        scratch.channel.clear();
        for (std::size_t i = 0; i < scratch.off.size(); i += step) {
            scratch.channel.push_back(scratch.off[i][c]);
        }
        const auto middle =
            scratch.channel.begin() + static_cast<std::ptrdiff_t>(scratch.channel.size() / 2);
        std::nth_element(scratch.channel.begin(), middle, scratch.channel.end());
        out[c] = *middle;
    }
    return out;
}

// visit(bin, scratch) for each of so many bins, on all cores.
template <class F>
void for_each_bin(std::size_t count, F&& visit) {
    tbb::enumerable_thread_specific<Scratch> scratches;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          Scratch& scratch = scratches.local();
                          for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              visit(i, scratch);
                          }
                      });
}

class Mean {
  public:
    void add(const PixelPair& pixel, double weight) {
        before_ = before_ + weight * to_double(pixel.before);
        after_ = after_ + weight * to_double(pixel.after);
        weight_ += weight;
    }
    ColorPair pair() const {
        return weight_ > 0 ? ColorPair{1 / weight_ * before_, 1 / weight_ * after_, weight_}
                           : ColorPair{{}, {}, 0};
    }

  private:
    RgbD before_, after_;
    double weight_ = 0;
};

} // namespace

ColorBins::ColorBins(std::vector<PixelPair> pixels, int side) {
    std::erase_if(pixels, [](const PixelPair& pixel) { return !is_finite(pixel); });
    for (PixelPair& pixel : pixels) {
        pixel = {saturate(pixel.before), held_to_halves(pixel.after)};
    }
    const auto n = static_cast<std::size_t>(side);
    std::vector<std::uint32_t> bins(pixels.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixels.size()),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              bins[i] = static_cast<std::uint32_t>(bin_of(pixels[i].before, side));
                          }
                      });
    std::vector<std::size_t> next(n * n * n + 1);
    for (const std::uint32_t b : bins) {
        ++next[b + 1];
    }
    first_.push_back(0);
    for (std::size_t b = 1; b < next.size(); ++b) {
        next[b] += next[b - 1];
        if (next[b] != first_.back()) {
            first_.push_back(next[b]);
        }
    }
    pixels_.resize(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels_[next[bins[i]]++] = pixels[i];
    }
}

std::vector<ColorPair> ColorBins::means() const {
    std::vector<ColorPair> out(size());
    for_each_bin(size(), [&](std::size_t i, Scratch&) {
        Mean mean;
        for (const PixelPair& pixel : bin(i)) {
            mean.add(pixel, 1);
        }
        out[i] = mean.pair();
    });
    return out;
}

std::vector<ColorPair> ColorBins::robust_means(const Transform& look, double limit) const {
    std::vector<ColorPair> out(size());
    for_each_bin(size(), [&](std::size_t i, Scratch& scratch) {
        const std::span<const PixelPair> pixels = bin(i);
        find_off(pixels, look, scratch);
        const RgbD middle = median_off(scratch);
        Mean mean;
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            const double share = largest_magnitude(scratch.off[k] - middle) / limit;
            const double kept = std::max(0.0, 1 - share * share);
            mean.add(pixels[k], kept * kept);
        }
        out[i] = mean.pair();
    });
    return out;
}

double ColorBins::noise(const Transform& look) const {
    using Counts = std::vector<std::size_t>;
    tbb::enumerable_thread_specific<Counts> counted(Counts(deviation_steps + 1));
    for_each_bin(size(), [&](std::size_t i, Scratch& scratch) {
        const std::span<const PixelPair> pixels = bin(i);
        // A median of so few lies on one of them.
        if (pixels.size() < 8) {
            return;
        }
        find_off(pixels, look, scratch);
        const RgbD middle = median_off(scratch);
        Counts& counts = counted.local();
        for (const RgbD& off : scratch.off) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double steps = std::abs(off[c] - middle[c]) / deviation_step;
                ++counts[static_cast<std::size_t>(
                    std::min(steps, static_cast<double>(deviation_steps)))];
            }
        }
    });
    Counts all(deviation_steps + 1);
    std::size_t sum = 0;
    for (const Counts& counts : counted) {
        for (std::size_t k = 0; k < all.size(); ++k) {
            all[k] += counts[k];
            sum += counts[k];
        }
    }
    std::size_t below = 0, at = 0;
    while (at < deviation_steps && 2 * (below + all[at]) < sum) {
        below += all[at++];
    }
    return sum > 0 ? deviation_of_median * (static_cast<double>(at) + 0.5) * deviation_step : 0;
}

} // namespace lutlib
