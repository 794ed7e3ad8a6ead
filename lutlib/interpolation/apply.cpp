#include "lutlib/interpolation/apply.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lutlib/interpolation/apply.cpp"
#include <hwy/foreach_target.h>

#include "lutlib/interpolation/lookups-inl.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <functional>

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

template <std::size_t channels>
HWY_INLINE Colors load(const float* p, V& alpha) {
    Colors out;
    if constexpr (channels == 4) {
        hn::LoadInterleaved4(D(), p, out.r, out.g, out.b, alpha);
    } else {
        hn::LoadInterleaved3(D(), p, out.r, out.g, out.b);
    }
    return out;
}

HWY_INLINE Colors shaped(const StoredLut& lut, const Colors& colors) {
    return lut.shaper() ? Colors{through_curve(*lut.shaper(), 0, colors.r),
                                 through_curve(*lut.shaper(), 1, colors.g),
                                 through_curve(*lut.shaper(), 2, colors.b)}
                        : colors;
}

template <class Fetch>
HWY_INLINE Pixel scaled(Pixel sum) {
    if constexpr (Fetch::scale == 1) {
        return sum;
    } else {
        return sum * Fetch::scale;
    }
}

// A vector's pixels; `in` is read in full before anything is written.
template <class Read, class Fetch, std::size_t channels>
HWY_INLINE void some_pixels(const StoredLut& lut, const float* in, float* out, Read& read) {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    V alpha = hn::Zero(d);
    const Colors colors = shaped(lut, load<channels>(in, alpha));
    if (lut.size() == 0) {
        if constexpr (channels == 4) {
            hn::StoreInterleaved4(colors.r, colors.g, colors.b, alpha, d, out);
        } else {
            hn::StoreInterleaved3(colors.r, colors.g, colors.b, d, out);
        }
        return;
    }
    read.find(lut, colors);
    HWY_ALIGN std::array<float, most_lanes> alphas;
    hn::Store(alpha, d, alphas.data());
    const std::uint8_t* const nodes = lut.nodes();
    if constexpr (channels == 4) {
        for (std::size_t i = 0; i < lanes; ++i) {
            store(scaled<Fetch>(read.at(nodes, i)), out + 4 * i);
            out[4 * i + 3] = alphas[i];
        }
    } else {
        // Each pixel's fourth number is written over by the next pixel.
        for (std::size_t i = 0; i + 1 < lanes; ++i) {
            store(scaled<Fetch>(read.at(nodes, i)), out + 3 * i);
        }
        std::array<float, 4> last;
        store(scaled<Fetch>(read.at(nodes, lanes - 1)), last.data());
        std::copy(last.begin(), last.begin() + 3, out + 3 * (lanes - 1));
    }
}

template <class Read, class Fetch, std::size_t channels>
void all_pixels(const StoredLut& lut, const float* in, float* out, std::size_t count) {
    const std::size_t lanes = hn::Lanes(D());
    Read read;
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        some_pixels<Read, Fetch, channels>(lut, in + channels * i, out + channels * i, read);
    }
    if (i < count) {
        std::array<float, channels * most_lanes> rest{};
        const auto left = static_cast<std::ptrdiff_t>(channels * (count - i));
        std::copy(in + channels * i, in + channels * count, rest.begin());
        some_pixels<Read, Fetch, channels>(lut, rest.data(), rest.data(), read);
        std::copy(rest.begin(), rest.begin() + left, out + channels * i);
    }
}

template <class Fetch, std::size_t channels>
void with_lookup(const StoredLut& lut, const Lookup& lookup, const float* in, float* out,
                 std::size_t count) {
    switch (lookup.weights) {
    case Interpolation::nearest:
        return all_pixels<Nearest<Fetch>, Fetch, channels>(lut, in, out, count);
    case Interpolation::trilinear:
        return lookup.fraction_bits > 0
                   ? all_pixels<Trilinear<Fetch, 8>, Fetch, channels>(lut, in, out, count)
                   : all_pixels<Trilinear<Fetch, 0>, Fetch, channels>(lut, in, out, count);
    case Interpolation::tetrahedral:
        return all_pixels<Tetrahedral<Fetch>, Fetch, channels>(lut, in, out, count);
    }
}

template <std::size_t channels>
void with_storage(const StoredLut& lut, const Lookup& lookup, const float* in, float* out,
                  std::size_t count) {
    switch (lut.storage().format) {
    case NodeFormat::codes8:
        return with_lookup<Codes8, channels>(lut, lookup, in, out, count);
    case NodeFormat::codes10:
        return with_lookup<Codes10, channels>(lut, lookup, in, out, count);
    case NodeFormat::codes16:
        return with_lookup<Codes16, channels>(lut, lookup, in, out, count);
    case NodeFormat::halves:
        return with_lookup<Halves, channels>(lut, lookup, in, out, count);
    case NodeFormat::floats:
        return with_lookup<Floats, channels>(lut, lookup, in, out, count);
    }
}

void Apply(const StoredLut& lut, const Lookup& lookup, const float* in, float* out,
           std::size_t count, std::size_t channels) {
    channels == 4 ? with_storage<4>(lut, lookup, in, out, count)
                  : with_storage<3>(lut, lookup, in, out, count);
}

template <std::size_t channels>
std::size_t count_outside(const Domain& domain, const float* in, std::size_t count) {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    const auto within = [d](V value, float min, float max) HWY_ATTR {
        return hn::And(hn::Ge(value, hn::Set(d, min)), hn::Le(value, hn::Set(d, max)));
    };
    std::size_t inside = 0, i = 0;
    for (; i + lanes <= count; i += lanes) {
        V alpha;
        const Colors c = load<channels>(in + channels * i, alpha);
        inside += hn::CountTrue(d, hn::And(within(c.r, domain.min.r, domain.max.r),
                                           hn::And(within(c.g, domain.min.g, domain.max.g),
                                                   within(c.b, domain.min.b, domain.max.b))));
    }
    for (; i < count; ++i) {
        const float* const p = in + channels * i;
        inside += p[0] >= domain.min.r && p[0] <= domain.max.r && p[1] >= domain.min.g &&
                  p[1] <= domain.max.g && p[2] >= domain.min.b && p[2] <= domain.max.b;
    }
    return count - inside;
}

std::size_t CountOutside(const Domain& domain, const float* in, std::size_t count,
                         std::size_t channels) {
    return channels == 4 ? count_outside<4>(domain, in, count)
                         : count_outside<3>(domain, in, count);
}

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lutlib {
namespace {

// Pixels that one core takes at a time: enough to be worth the taking, few enough to share out.
constexpr std::size_t grain = 8192;

} // namespace

HWY_EXPORT(Apply);
HWY_EXPORT(CountOutside);

void apply_on_this_thread(const StoredLut& lut, const Lookup& lookup, const float* in, float* out,
                          std::size_t pixels, std::size_t channels) {
    HWY_DYNAMIC_DISPATCH(Apply)
    (lut, lookup, in, out, pixels, channels);
}

std::size_t pixels_outside(const Domain& domain, const float* in, std::size_t pixels,
                           std::size_t channels) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, pixels, grain), std::size_t{0},
        [&](const auto& range, std::size_t sum) {
            return sum + HWY_DYNAMIC_DISPATCH(CountOutside)(domain, in + channels * range.begin(),
                                                            range.size(), channels);
        },
        std::plus<>());
}

} // namespace lutlib
#endif
