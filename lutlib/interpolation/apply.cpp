#include "lutlib/interpolation/apply.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lutlib/interpolation/apply.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Many pixels, a channel at a time.
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
using DI = hn::RebindToSigned<D>;
using VI = hn::Vec<DI>;
constexpr std::size_t most_lanes = 16;

// One pixel, its channels side by side.
#if HWY_TARGET == HWY_SCALAR
// Highway's last resort has vectors of one number only.
struct Pixel {
    std::array<float, 4> channel{};
};
template <class F>
Pixel pixel_of(F f) {
    return {{f(0), f(1), f(2), f(3)}};
}
template <class T>
Pixel loaded(const T* p) {
    const hn::FixedTag<T, 1> d;
    return pixel_of([&](std::size_t c) {
        if constexpr (std::is_same_v<T, hwy::float16_t>) {
            return hn::GetLane(hn::PromoteTo(hn::FixedTag<float, 1>(), hn::LoadU(d, p + c)));
        } else {
            return static_cast<float>(hn::GetLane(hn::LoadU(d, p + c)));
        }
    });
}
Pixel unpacked_10_bits(std::uint32_t word) {
    return pixel_of([word](std::size_t c) {
        return static_cast<float>(static_cast<int>(word >> (10 * c) & 1023));
    });
}
Pixel operator+(Pixel a, Pixel b) {
    return pixel_of([&](std::size_t c) { return a.channel[c] + b.channel[c]; });
}
Pixel operator*(Pixel a, float s) {
    return pixel_of([&](std::size_t c) { return a.channel[c] * s; });
}
void store(Pixel a, float* p) {
    std::copy(a.channel.begin(), a.channel.end(), p);
}
#else
using D4 = hn::FixedTag<float, 4>;
struct Pixel {
    hn::Vec<D4> channels;
};
template <class T>
HWY_INLINE Pixel loaded(const T* p) {
    const auto v = hn::LoadU(hn::FixedTag<T, 4>(), p);
    if constexpr (std::is_same_v<T, float>) {
        return {v};
    } else if constexpr (std::is_same_v<T, hwy::float16_t>) {
        return {hn::PromoteTo(D4(), v)};
    } else {
        return {hn::ConvertTo(D4(), hn::PromoteTo(hn::RebindToSigned<D4>(), v))};
    }
}
HWY_INLINE Pixel unpacked_10_bits(std::uint32_t word) {
    const hn::RebindToUnsigned<D4> d;
    HWY_ALIGN static constexpr std::uint32_t shifts[4] = {0, 10, 20, 30};
    const auto codes = hn::And(hn::Shr(hn::Set(d, word), hn::Load(d, shifts)), hn::Set(d, 1023));
    return {hn::ConvertTo(D4(), hn::BitCast(hn::RebindToSigned<D4>(), codes))};
}
HWY_INLINE Pixel operator+(Pixel a, Pixel b) {
    return {hn::Add(a.channels, b.channels)};
}
HWY_INLINE Pixel operator*(Pixel a, float s) {
    return {hn::Mul(a.channels, hn::Set(D4(), s))};
}
HWY_INLINE void store(Pixel a, float* p) {
    hn::StoreU(a.channels, D4(), p);
}
#endif

struct Colours {
    V r, g, b;
};

// How a node's values are loaded: 16 bytes at most from its first.
struct Codes8 {
    static constexpr std::size_t bytes = 3;
    static constexpr float scale = 1.0F / 255;
    static HWY_INLINE Pixel at(const std::uint8_t* p) { return loaded(p); }
};
struct Codes10 {
    static constexpr std::size_t bytes = 4;
    static constexpr float scale = 1.0F / 1023;
    static HWY_INLINE Pixel at(const std::uint8_t* p) {
        std::uint32_t word;
        std::memcpy(&word, p, sizeof word);
        return unpacked_10_bits(word);
    }
};
struct Codes16 {
    static constexpr std::size_t bytes = 6;
    static constexpr float scale = 1.0F / 65535;
    static HWY_INLINE Pixel at(const std::uint8_t* p) {
        return loaded(reinterpret_cast<const std::uint16_t*>(p));
    }
};
struct Halves {
    static constexpr std::size_t bytes = 6;
    static constexpr float scale = 1;
    static HWY_INLINE Pixel at(const std::uint8_t* p) {
        return loaded(reinterpret_cast<const hwy::float16_t*>(p));
    }
};
struct Floats {
    static constexpr std::size_t bytes = 12;
    static constexpr float scale = 1;
    static HWY_INLINE Pixel at(const std::uint8_t* p) {
        return loaded(reinterpret_cast<const float*>(p));
    }
};

// In units of nodes, 0 .. size-1. The comparison's form sends NaN to 0.
HWY_INLINE V lattice_coordinate(V value, float min, float max, int size) {
    const D d;
    const V t = hn::Div(hn::Sub(value, hn::Set(d, min)), hn::Set(d, max - min));
    const V held = hn::IfThenElseZero(hn::Gt(t, hn::Zero(d)), hn::Min(t, hn::Set(d, 1)));
    return hn::Mul(held, hn::Set(d, static_cast<float>(size - 1)));
}

struct CellAxis {
    VI i;
    V f;
};

HWY_INLINE CellAxis locate(V value, float min, float max, int size) {
    const V x = lattice_coordinate(value, min, max, size);
    const VI i = hn::Min(hn::ConvertTo(DI(), x), hn::Set(DI(), size - 2));
    return {i, hn::Sub(x, hn::ConvertTo(D(), i))};
}

HWY_INLINE V through_curve(const Lut1D& curve, std::size_t c, V value) {
    const D d;
    const CellAxis at = locate(value, curve.domain.min[c], curve.domain.max[c], curve.size());
    const float* const first = &curve.entries[0].r + c;
    const VI index = hn::Mul(at.i, hn::Set(DI(), 3));
    const V low = hn::GatherIndex(d, first, index);
    const V high = hn::GatherIndex(d, first + 3, index);
    return hn::Add(hn::Mul(low, hn::Sub(hn::Set(d, 1), at.f)), hn::Mul(high, at.f));
}

// Of each pixel of a vector, the offset in bytes of nodes and what they weigh.
template <std::size_t nodes>
struct Reads {
    HWY_ALIGN std::array<std::array<std::int32_t, most_lanes>, nodes> offset;
    HWY_ALIGN std::array<std::array<float, most_lanes>, nodes> weight;
};

// The lookups: find() for all pixels of a vector, at() for one of them.
template <class Fetch>
class Nearest {
  public:
    HWY_INLINE void find(const StoredLut& lut, const Colours& in) {
        const Domain& domain = lut.cube_domain();
        const int n = lut.size();
        const auto bytes = static_cast<std::int32_t>(Fetch::bytes);
        const VI side = hn::Set(DI(), n);
        const VI node = hn::Add(
            index(in.r, domain.min.r, domain.max.r, n),
            hn::Mul(side, hn::Add(index(in.g, domain.min.g, domain.max.g, n),
                                  hn::Mul(side, index(in.b, domain.min.b, domain.max.b, n)))));
        hn::Store(hn::Mul(node, hn::Set(DI(), bytes)), DI(), offset_.data());
    }
    HWY_INLINE Pixel at(const std::uint8_t* nodes, std::size_t pixel) const {
        return Fetch::at(nodes + offset_[pixel]);
    }

  private:
    static HWY_INLINE VI index(V value, float min, float max, int size) {
        const V x = lattice_coordinate(value, min, max, size);
        return hn::ConvertTo(DI(), hn::Add(x, hn::Set(D(), 0.5F)));
    }

    HWY_ALIGN std::array<std::int32_t, most_lanes> offset_;
};

template <class Fetch>
struct Cell {
    CellAxis r, g, b;
    std::int32_t dr, dg, db; // steps to the next node, in bytes

    HWY_INLINE Cell(const StoredLut& lut, const Colours& in) {
        const Domain& domain = lut.cube_domain();
        const int n = lut.size();
        r = locate(in.r, domain.min.r, domain.max.r, n);
        g = locate(in.g, domain.min.g, domain.max.g, n);
        b = locate(in.b, domain.min.b, domain.max.b, n);
        dr = static_cast<std::int32_t>(Fetch::bytes);
        dg = dr * n;
        db = dg * n;
    }

    HWY_INLINE VI dark_corner() const {
        const DI d;
        return hn::Add(hn::Mul(r.i, hn::Set(d, dr)),
                       hn::Add(hn::Mul(g.i, hn::Set(d, dg)), hn::Mul(b.i, hn::Set(d, db))));
    }
};

// From the dark corner to the bright one, along the axes in order of falling fraction.
template <class Fetch>
class Tetrahedral {
  public:
    HWY_INLINE void find(const StoredLut& lut, const Colours& in) {
        const Cell<Fetch> cell(lut, in);
        const D d;
        const DI di;
        Axis x{cell.r.f, hn::Set(di, cell.dr)}, y{cell.g.f, hn::Set(di, cell.dg)},
            z{cell.b.f, hn::Set(di, cell.db)};
        order(x, y);
        order(y, z);
        order(x, y);
        const VI corner = cell.dark_corner();
        const VI first = hn::Add(corner, x.step), second = hn::Add(first, y.step);
        const VI last = hn::Add(second, z.step);
        put(0, corner, hn::Sub(hn::Set(d, 1), x.f));
        put(1, first, hn::Sub(x.f, y.f));
        put(2, second, hn::Sub(y.f, z.f));
        put(3, last, z.f);
    }
    HWY_INLINE Pixel at(const std::uint8_t* nodes, std::size_t pixel) const {
        return term(nodes, 0, pixel) + term(nodes, 1, pixel) + term(nodes, 2, pixel) +
               term(nodes, 3, pixel);
    }

  private:
    struct Axis {
        V f;
        VI step;
    };
    static HWY_INLINE void order(Axis& a, Axis& b) {
        const auto falls = hn::Ge(a.f, b.f);
        const auto falls_i = hn::RebindMask(DI(), falls);
        const Axis high{hn::IfThenElse(falls, a.f, b.f), hn::IfThenElse(falls_i, a.step, b.step)};
        b = {hn::IfThenElse(falls, b.f, a.f), hn::IfThenElse(falls_i, b.step, a.step)};
        a = high;
    }
    HWY_INLINE Pixel term(const std::uint8_t* nodes, std::size_t k, std::size_t pixel) const {
        return Fetch::at(nodes + reads_.offset[k][pixel]) * reads_.weight[k][pixel];
    }
    HWY_INLINE void put(std::size_t k, VI offset, V weight) {
        hn::Store(offset, DI(), reads_.offset[k].data());
        hn::Store(weight, D(), reads_.weight[k].data());
    }

    Reads<4> reads_;
};

// With fractions in full, or rounded to so many bits.
template <class Fetch, int fraction_bits>
class Trilinear {
  public:
    HWY_INLINE void find(const StoredLut& lut, const Colours& in) {
        const Cell<Fetch> cell(lut, in);
        dg_ = cell.dg;
        db_ = cell.db;
        hn::Store(cell.dark_corner(), DI(), offset_.data());
        put(0, cell.r.f);
        put(1, cell.g.f);
        put(2, cell.b.f);
    }
    HWY_INLINE Pixel at(const std::uint8_t* nodes, std::size_t pixel) const {
        const std::uint8_t* const corner = nodes + offset_[pixel];
        const Pixel dark = mix(row(corner, pixel), row(corner + dg_, pixel), 1, pixel);
        const Pixel bright =
            mix(row(corner + db_, pixel), row(corner + db_ + dg_, pixel), 1, pixel);
        return mix(dark, bright, 2, pixel);
    }

  private:
    HWY_INLINE Pixel mix(Pixel low, Pixel high, std::size_t axis, std::size_t pixel) const {
        return low * rest_[axis][pixel] + high * fraction_[axis][pixel];
    }
    HWY_INLINE Pixel row(const std::uint8_t* p, std::size_t pixel) const {
        return mix(Fetch::at(p), Fetch::at(p + Fetch::bytes), 0, pixel);
    }
    HWY_INLINE void put(std::size_t axis, V fraction) {
        const D d;
        if constexpr (fraction_bits > 0) {
            const V steps = hn::Set(d, static_cast<float>(1 << fraction_bits));
            const V step = hn::Set(d, 1 / static_cast<float>(1 << fraction_bits));
            fraction =
                hn::Mul(hn::Floor(hn::Add(hn::Mul(fraction, steps), hn::Set(d, 0.5F))), step);
        }
        hn::Store(fraction, d, fraction_[axis].data());
        hn::Store(hn::Sub(hn::Set(d, 1), fraction), d, rest_[axis].data());
    }

    HWY_ALIGN std::array<std::int32_t, most_lanes> offset_;
    HWY_ALIGN std::array<std::array<float, most_lanes>, 3> fraction_, rest_;
    std::ptrdiff_t dg_ = 0, db_ = 0;
};

template <std::size_t channels>
HWY_INLINE Colours load(const float* p, V& alpha) {
    Colours out;
    if constexpr (channels == 4) {
        hn::LoadInterleaved4(D(), p, out.r, out.g, out.b, alpha);
    } else {
        hn::LoadInterleaved3(D(), p, out.r, out.g, out.b);
    }
    return out;
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
    Colours colours = load<channels>(in, alpha);
    if (lut.shaper()) {
        colours = {through_curve(*lut.shaper(), 0, colours.r),
                   through_curve(*lut.shaper(), 1, colours.g),
                   through_curve(*lut.shaper(), 2, colours.b)};
    }
    if (lut.size() == 0) {
        if constexpr (channels == 4) {
            hn::StoreInterleaved4(colours.r, colours.g, colours.b, alpha, d, out);
        } else {
            hn::StoreInterleaved3(colours.r, colours.g, colours.b, d, out);
        }
        return;
    }
    read.find(lut, colours);
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
        const Colours c = load<channels>(in + channels * i, alpha);
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
    HWY_DYNAMIC_DISPATCH(Apply)(lut, lookup, in, out, pixels, channels);
}

void apply(const StoredLut& lut, const Lookup& lookup, const float* in, float* out,
           std::size_t pixels, std::size_t channels) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixels, grain), [&](const auto& range) {
        const std::size_t first = channels * range.begin();
        apply_on_this_thread(lut, lookup, in + first, out + first, range.size(), channels);
    });
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
