#include "lutlib/match/color_bins.h"

#include "lutlib/color/transfer_curve.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

// Of a bin, as many as tell its median.
constexpr std::size_t enough_for_median = 255;
// A median of fewer pixels lies on one of them.
constexpr std::size_t fewest_for_noise = 8;
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

Clipped clipped_of(Rgb after, bool codes_end) {
    Clipped out{};
    for (std::size_t c = 0; codes_end && c < 3; ++c) {
        out[c] = static_cast<std::int8_t>(after[c] >= 1 ? 1 : after[c] <= 0 ? -1 : 0);
    }
    return out;
}

// A pixel and what it is sorted by, which costs less than to find that anew for each comparison.
struct Keyed {
    std::array<std::uint64_t, 4> key;
    PixelPair pixel;
};

// The bits of finite floats, two zeros as one, rising with them: those below 0 are counted down.
std::uint64_t rising_bits(float x) {
    constexpr std::uint32_t sign = 0x80000000U;
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0F);
    return bits & sign ? ~bits : bits | sign;
}

// By the clipped channels and the tetrahedron.
std::uint64_t group_key(const PixelPair& pixel, bool codes_end, int nodes) {
    std::uint64_t out = 0;
    for (const std::int8_t of_channel : clipped_of(pixel.after, codes_end)) {
        out = 3 * out + static_cast<std::uint64_t>(of_channel + 1);
    }
    Rgb beyond; // the node before it
    for (std::size_t c = 0; nodes > 0 && c < 3; ++c) {
        const float place = pixel.before[c] * static_cast<float>(nodes - 1);
        beyond[c] = place - std::min(std::floor(place), static_cast<float>(nodes - 2));
    }
    return 8 * out + (beyond.r > beyond.g ? 4 : 0) + (beyond.g > beyond.b ? 2 : 0) +
           (beyond.r > beyond.b ? 1 : 0);
}

// By its group, then the colour before and the one after.
Keyed keyed(const PixelPair& pixel, std::uint64_t group) {
    constexpr unsigned half = 32;
    const Rgb before = pixel.before, after = pixel.after;
    return {{group << half | rising_bits(before.r),
             rising_bits(before.g) << half | rising_bits(before.b),
             rising_bits(after.r) << half | rising_bits(after.g), rising_bits(after.b)},
            pixel};
}

// Of pixels, each within its bin: those of one group, and of one colour, together.
void sort_bin(std::span<PixelPair> pixels, bool codes_end, int nodes, std::vector<Keyed>& room) {
    room.clear();
    for (const PixelPair& pixel : pixels) {
        room.push_back(keyed(pixel, group_key(pixel, codes_end, nodes)));
    }
    std::sort(room.begin(), room.end(),
              [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
    std::transform(room.begin(), room.end(), pixels.begin(),
                   [](const Keyed& one) { return one.pixel; });
}

// What is used again for each bin that a thread works on.
struct Scratch {
    std::vector<RgbD> off; ///< of each entry, from the look
    std::vector<std::pair<double, std::size_t>> channel;
    std::vector<Keyed> keyed;
};

template <class Entries>
RgbD median_off(const Entries& entries, Scratch& scratch) {
    const std::size_t step = 1 + scratch.off.size() / enough_for_median;
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        scratch.channel.clear();
        std::size_t pixels = 0;
        for (std::size_t i = 0; i < scratch.off.size(); i += step) {
            scratch.channel.emplace_back(scratch.off[i][c], entries[i].count);
            pixels += entries[i].count;
        }
        std::sort(scratch.channel.begin(), scratch.channel.end());
        std::size_t below = 0;
        for (const auto& [off, count] : scratch.channel) {
            below += count;
            if (2 * below > pixels) {
                out[c] = off;
                break;
            }
        }
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
    void add(Rgb before, Rgb after, double weight) {
        before_ = before_ + weight * to_double(before);
        after_ = after_ + weight * to_double(after);
        weight_ += weight;
    }
    double weight() const { return weight_; }
    ColorPair pair(const Clipped& clipped, double weight) const {
        return weight_ > 0 ? ColorPair{1 / weight_ * before_, 1 / weight_ * after_, weight, clipped}
                           : ColorPair{{}, {}, 0, clipped};
    }
    // So that it counts so much, whatever it is made of.
    void add(const Mean& other, double weight) {
        const double by = weight / other.weight_;
        before_ = before_ + by * other.before_;
        after_ = after_ + by * other.after_;
        weight_ += weight;
    }

  private:
    RgbD before_, after_;
    double weight_ = 0;
};

} // namespace

ColorBins::ColorBins(std::vector<PixelPair> pixels, int side, bool codes_end, int nodes) {
    std::erase_if(pixels, [](const PixelPair& pixel) { return !is_finite(pixel); });
    const auto n = static_cast<std::size_t>(side);
    std::vector<std::uint32_t> bins(pixels.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, pixels.size()),
        [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                pixels[i] = {saturate(pixels[i].before), held_to_halves(pixels[i].after)};
                bins[i] = static_cast<std::uint32_t>(bin_of(pixels[i].before, side));
            }
        });
    std::vector<std::size_t> next(n * n * n + 1);
    for (const std::uint32_t b : bins) {
        ++next[b + 1];
    }
    std::vector<std::size_t> first{0};
    for (std::size_t b = 1; b < next.size(); ++b) {
        next[b] += next[b - 1];
        if (next[b] != first.back()) {
            first.push_back(next[b]);
        }
    }
    std::vector<PixelPair> sorted(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        sorted[next[bins[i]]++] = pixels[i];
    }
    pixels_ = pixels.size();
    for_each_bin(first.size() - 1, [&](std::size_t i, Scratch& scratch) {
        sort_bin(std::span(sorted).subspan(first[i], first[i + 1] - first[i]), codes_end, nodes,
                 scratch.keyed);
    });
    for (std::size_t b = 0; b + 1 < first.size(); ++b) {
        bins_.push_back({entries_.size(), groups_.size()});
        for (std::size_t i = first[b]; i < first[b + 1]; ++i) {
            const PixelPair& pixel = sorted[i];
            const std::uint64_t key = group_key(pixel, codes_end, nodes);
            const bool is_new = groups_.size() == bins_.back().group || groups_.back().key != key;
            if (is_new) {
                groups_.push_back({entries_.size(), clipped_of(pixel.after, codes_end), key});
            }
            if (is_new || entries_.back().before != pixel.before ||
                entries_.back().after != pixel.after) {
                entries_.push_back({pixel.before, pixel.after, 0});
            }
            ++entries_.back().count;
            groups_.back().end = entries_.size();
        }
    }
    bins_.push_back({entries_.size(), groups_.size()});
}

void ColorBins::find_off(std::size_t bin, const Transform& look, std::vector<RgbD>& off) const {
    const std::span<const Entry> all = entries(bin);
    off.clear();
    for (const Entry& entry : all) {
        off.push_back(to_double(entry.before));
    }
    look(off);
    std::size_t i = 0;
    for (std::size_t g = bins_[bin].group; g < bins_[bin + 1].group; ++g) {
        for (; bins_[bin].entry + i < groups_[g].end; ++i) {
            off[i] = off_by(to_double(all[i].after), off[i], groups_[g].clipped);
        }
    }
}

std::vector<ColorPair> ColorBins::means() const {
    std::vector<ColorPair> out(size());
    for_each_bin(bins_.size() - 1, [&](std::size_t b, Scratch&) {
        std::size_t i = bins_[b].entry;
        for (std::size_t g = bins_[b].group; g < bins_[b + 1].group; ++g) {
            Mean mean;
            for (; i < groups_[g].end; ++i) {
                mean.add(entries_[i].before, entries_[i].after, entries_[i].count);
            }
            out[g] = mean.pair(groups_[g].clipped, mean.weight());
        }
    });
    return out;
}

std::vector<ColorPair> ColorBins::robust_means(const Transform& look, double limit,
                                               const PixelNoise& noise) const {
    std::vector<ColorPair> out(size());
    const double rounding = noise.rounding * noise.rounding, own = noise.own * noise.own;
    for_each_bin(bins_.size() - 1, [&](std::size_t b, Scratch& scratch) {
        find_off(b, look, scratch.off);
        const RgbD middle = median_off(entries(b), scratch);
        std::size_t i = bins_[b].entry;
        for (std::size_t g = bins_[b].group; g < bins_[b + 1].group; ++g) {
            Mean mean;
            const bool is_rounded = groups_[g].clipped == Clipped{};
            while (i < groups_[g].end) {
                const Rgb before = entries_[i].before;
                Mean of_color;
                double pixels = 0;
                for (; i < groups_[g].end && entries_[i].before == before; ++i) {
                    const double share =
                        largest_magnitude(scratch.off[i - bins_[b].entry] - middle) / limit;
                    const double kept = std::max(0.0, 1 - share * share);
                    of_color.add(before, entries_[i].after, kept * kept * entries_[i].count);
                    pixels += entries_[i].count;
                }
                if (of_color.weight() > 0) {
                    const double rounded =
                        rounding + own > 0 ? (rounding + own) / (rounding + own / pixels) : pixels;
                    const double different =
                        is_rounded ? rounded : std::max(rounded, std::sqrt(pixels));
                    mean.add(of_color, different * of_color.weight() / pixels);
                }
            }
            out[g] = mean.pair(groups_[g].clipped, mean.weight());
        }
    });
    return out;
}

double ColorBins::noise(const Transform& look) const {
    using Counts = std::vector<std::size_t>;
    tbb::enumerable_thread_specific<Counts> counted(Counts(deviation_steps + 1));
    for_each_bin(bins_.size() - 1, [&](std::size_t b, Scratch& scratch) {
        const std::span<const Entry> all = entries(b);
        std::size_t pixels = 0;
        for (const Entry& entry : all) {
            pixels += entry.count;
        }
        if (pixels < fewest_for_noise) {
            return;
        }
        find_off(b, look, scratch.off);
        const RgbD middle = median_off(all, scratch);
        Counts& counts = counted.local();
        std::size_t i = 0;
        for (std::size_t g = bins_[b].group; g < bins_[b + 1].group; ++g) {
            for (; bins_[b].entry + i < groups_[g].end; ++i) {
                for (std::size_t c = 0; c < 3; ++c) {
                    if (groups_[g].clipped[c] == 0) {
                        const double steps =
                            std::abs(scratch.off[i][c] - middle[c]) / deviation_step;
                        counts[static_cast<std::size_t>(
                            std::min(steps, static_cast<double>(deviation_steps)))] += all[i].count;
                    }
                }
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
