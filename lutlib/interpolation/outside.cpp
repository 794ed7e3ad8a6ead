#include "lutlib/half.h"
#include "lutlib/interpolation/apply.h"
#include "lutlib/interpolation/grade.h"
#include "lutlib/interpolation/sample.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>

namespace lutlib {
namespace {

// Halves in the order of their values, from the least on; NaN beyond both ends.
int place_of(std::uint16_t half) {
    constexpr int sign = 0x8000, infinity = 0x7C00;
    const int magnitude = half & (sign - 1);
    return (half & sign) == 0 ? magnitude : magnitude > infinity ? sign : -magnitude;
}

// The halves that lie from `min` to `max`.
struct Places {
    Places(float min, float max) : first(nearest(min)), last(nearest(max)) {
        first += value(first) < min ? 1 : 0;
        last -= value(last) > max ? 1 : 0;
    }
    bool hold(std::uint16_t half) const {
        const int place = place_of(half);
        return place >= first && place <= last;
    }

    int first, last;

  private:
    static int nearest(float bound) { return place_of(half_near(bound)); }
    static float value(int place) {
        constexpr int sign = 0x8000;
        return float_from_half(static_cast<std::uint16_t>(place < 0 ? sign - place : place));
    }
};

std::size_t halves_outside(const Domain& domain, const ConstPictureView& in, std::size_t y) {
    const std::array<Places, 3> bounds{Places(domain.min.r, domain.max.r),
                                       Places(domain.min.g, domain.max.g),
                                       Places(domain.min.b, domain.max.b)};
    std::size_t out = 0;
    for (std::size_t x = 0; x < in.width; ++x) {
        bool is_inside = true;
        for (std::size_t c = 0; c < 3; ++c) {
            std::uint16_t half = 0;
            std::memcpy(&half, in.at(c, x, y), sizeof half);
            is_inside = is_inside & bounds[c].hold(half);
        }
        out += is_inside ? 0 : 1;
    }
    return out;
}

std::size_t outside(const Domain& domain, const ConstPictureView& in, std::size_t y) {
    std::size_t out = 0;
    for (std::size_t x = 0; x < in.width; ++x) {
        bool is_inside = true;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = sample_value(in.element, in.at(c, x, y));
            is_inside = is_inside && value >= static_cast<double>(domain.min[c]) &&
                        value <= static_cast<double>(domain.max[c]);
        }
        out += is_inside ? 0 : 1;
    }
    return out;
}

// Floats of 3 or 4 channels without gaps in a row; 0: they lie otherwise.
std::size_t channels_of_floats(const ConstPictureView& in) {
    constexpr std::ptrdiff_t size = sizeof(float);
    const std::ptrdiff_t stride = in.pixel_stride;
    const bool are_beside =
        in.channel[1] == in.channel[0] + size && in.channel[2] == in.channel[0] + 2 * size;
    const bool are_packed = stride == 3 * size || stride == 4 * size;
    return in.element == Element::float32 && are_beside && are_packed
               ? static_cast<std::size_t>(stride / size)
               : 0;
}

} // namespace

std::size_t pixels_outside(const Domain& domain, const ConstPictureView& in) {
    const std::size_t channels = channels_of_floats(in);
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, in.height), std::size_t{0},
        [&](const auto& rows, std::size_t sum) {
            for (std::size_t y = rows.begin(); y < rows.end(); ++y) {
                sum += channels > 0
                           ? pixels_outside(domain, reinterpret_cast<const float*>(in.at(0, 0, y)),
                                            in.width, channels)
                       : in.element == Element::half ? halves_outside(domain, in, y)
                                                     : outside(domain, in, y);
            }
            return sum;
        },
        std::plus<>());
}

std::size_t pixels_with_nan(const ConstPictureView& in) {
    if (info_of(in.element).maximum > 0) {
        return 0;
    }
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, in.height), std::size_t{0},
        [&](const auto& rows, std::size_t sum) {
            for (std::size_t y = rows.begin(); y < rows.end(); ++y) {
                for (std::size_t x = 0; x < in.width; ++x) {
                    const auto is_nan = [&](std::size_t c) {
                        return std::isnan(sample_value(in.element, in.at(c, x, y)));
                    };
                    sum += is_nan(0) || is_nan(1) || is_nan(2) ? 1 : 0;
                }
            }
            return sum;
        },
        std::plus<>());
}

} // namespace lutlib
