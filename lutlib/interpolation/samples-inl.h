// A vector of pixels of four samples, loaded as floats and stored with the alpha they came with.
// Compiled once for each instruction set, as grade_kernels.cpp is.
#if defined(LUTLIB_INTERPOLATION_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LUTLIB_INTERPOLATION_SAMPLES_INL_H
#undef LUTLIB_INTERPOLATION_SAMPLES_INL_H
#else
#define LUTLIB_INTERPOLATION_SAMPLES_INL_H
#endif

#include "lutlib/half.h"
#include "lutlib/interpolation/lookups-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t lanes = hn::MaxLanes(D());
/// Pixels of four floats that a vector holds.
constexpr std::size_t blocks = lanes / 4;

/// Halves are converted by one instruction that rounds to nearest.
constexpr bool converts_halves = HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2;

/// Of each pixel the same lane: four vectors of one channel each, from four of pixels side by side,
/// and back. Lane 4 j + k of a channel is of the pixel in block j of vector k.
HWY_INLINE void transpose(V& a, V& b, V& c, V& d) {
    const D tag;
    const hn::Repartition<std::uint64_t, D> pairs;
    const auto ab = hn::BitCast(pairs, hn::InterleaveLower(tag, a, b));
    const auto ab_high = hn::BitCast(pairs, hn::InterleaveUpper(tag, a, b));
    const auto cd = hn::BitCast(pairs, hn::InterleaveLower(tag, c, d));
    const auto cd_high = hn::BitCast(pairs, hn::InterleaveUpper(tag, c, d));
    a = hn::BitCast(tag, hn::InterleaveLower(pairs, ab, cd));
    b = hn::BitCast(tag, hn::InterleaveUpper(pairs, ab, cd));
    c = hn::BitCast(tag, hn::InterleaveLower(pairs, ab_high, cd_high));
    d = hn::BitCast(tag, hn::InterleaveUpper(pairs, ab_high, cd_high));
}

/// The nearest whole number, of two the even one, of 0 .. 2^22: what is added leaves a float no
/// bits for a fraction.
HWY_INLINE VI nearest_whole(V v) {
    const V magic = hn::Set(D(), 3 << 22);
    return hn::Sub(hn::BitCast(DI(), hn::Add(v, magic)), hn::BitCast(DI(), magic));
}

/// Codes are not yet divided by their maximum.
template <class T>
HWY_INLINE V load_samples(const T* p) {
    const D d;
    if constexpr (std::is_same_v<T, float>) {
        return hn::LoadU(d, p);
    } else {
        const auto narrow = hn::LoadU(hn::Rebind<T, D>(), p);
        if constexpr (std::is_same_v<T, hwy::float16_t>) {
            return hn::PromoteTo(d, narrow);
        } else {
            return hn::ConvertTo(d, hn::PromoteTo(DI(), narrow));
        }
    }
}

/// Stores vectors of `blocks` pixels, of sums from `least` to `largest`.
template <class T>
class Store {
  public:
    HWY_INLINE Store(float maximum, bool streams, float least, float largest)
        : maximum_(maximum), streams_(streams), holds_all_(holds(least, largest)) {
        HWY_ALIGN std::array<Bits, most_lanes> fourths{};
        for (std::size_t i = 3; i < most_lanes; i += 4) {
            fourths[i] = 1;
        }
        const hn::Rebind<Bits, D> d;
        is_alpha_ = hn::Ne(hn::Load(d, fourths.data()), hn::Zero(d));
    }
    /// Colours of `sum`, times the maximum where they are codes; alpha of the pixels at `in`.
    HWY_INLINE void operator()(V sum, const T* in, T* out) const {
        const hn::Rebind<Bits, D> bits;
        const hn::Rebind<T, D> d;
        const auto colors = hn::BitCast(bits, narrowed(sum));
        const auto both =
            hn::BitCast(d, hn::IfThenElse(is_alpha_, hn::BitCast(bits, hn::LoadU(d, in)), colors));
        if constexpr (lanes * sizeof(T) >= 16) {
            if (streams_) {
                hn::Stream(both, d, out);
                return;
            }
        }
        hn::StoreU(both, d, out);
    }

  private:
    using Bits = hwy::UnsignedFromSize<sizeof(T)>;

    static bool holds(float least, float largest) {
        if constexpr (std::is_integral_v<T>) {
            return least >= 0 && largest <= 1;
        } else {
            return least >= -largest_half && largest <= largest_half;
        }
    }

    HWY_INLINE auto narrowed(V sum) const {
        const D d;
        const hn::Rebind<T, D> narrow;
        if constexpr (std::is_same_v<T, float>) {
            return sum;
        } else if constexpr (std::is_same_v<T, hwy::float16_t>) {
            if (!holds_all_) {
                const V most = hn::Set(d, static_cast<float>(largest_half));
                sum = hn::Min(hn::Max(sum, hn::Neg(most)), most);
            }
            return hn::DemoteTo(narrow, sum);
        } else {
            const V most = hn::Set(d, maximum_);
            V codes = hn::Mul(sum, most);
            if (!holds_all_) {
                codes = hn::Min(hn::Max(codes, hn::Zero(d)), most);
            }
            return hn::DemoteTo(narrow, nearest_whole(codes));
        }
    }

    float maximum_;
    bool streams_, holds_all_;
    decltype(hn::Ne(hn::Zero(hn::Rebind<Bits, D>()), hn::Zero(hn::Rebind<Bits, D>()))) is_alpha_;
};

#endif

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
