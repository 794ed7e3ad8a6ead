// Sums of nodes in floats, a vector of pixels at a time, each from pairs of nodes that lie side by
// side. Work goes in strips: first the places and weights of all pixels, as many to a vector as it
// has floats; then their sums. So no sum waits for its own pixel's place.
// Compiled once for each instruction set, as grade_kernels.cpp is.
#if defined(LUTLIB_INTERPOLATION_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LUTLIB_INTERPOLATION_PAIRS_INL_H
#undef LUTLIB_INTERPOLATION_PAIRS_INL_H
#else
#define LUTLIB_INTERPOLATION_PAIRS_INL_H
#endif

#include "lutlib/interpolation/grade_tables.h"
#include "lutlib/interpolation/samples-inl.h"

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

constexpr std::size_t strip = 256;

/// Where a cell begins, in nodes, and how far the colour lies from there to the next nodes.
struct Place {
    V r, g, b, cell;
};

/// Finds places of colours whose samples are codes of 0 .. `maximum`, or floats where that is 1.
template <bool are_codes>
class Places {
  public:
    HWY_INLINE Places(const GradeTables& tables, float maximum)
        : tables_(tables), maximum_(maximum), top_(static_cast<float>(tables.size - 1)) {}

    HWY_INLINE Place operator()(V r, V g, V b) const {
        const D d;
        if (tables_.is_plain) {
            const V scale = hn::Set(d, top_ / maximum_);
            r = held(hn::Mul(r, scale));
            g = held(hn::Mul(g, scale));
            b = held(hn::Mul(b, scale));
        } else {
            r = along(r, 0);
            g = along(g, 1);
            b = along(b, 2);
        }
        if (tables_.how == Interpolation::nearest) {
            const V half = hn::Set(d, 0.5F);
            r = hn::Floor(hn::Add(r, half));
            g = hn::Floor(hn::Add(g, half));
            b = hn::Floor(hn::Add(b, half));
        }
        const V i = hn::Floor(r), j = hn::Floor(g), k = hn::Floor(b);
        const V side = hn::Set(d, top_ + 1); // 256^3 at most: exact in floats
        const V cell = hn::Add(i, hn::Mul(side, hn::Add(j, hn::Mul(side, k))));
        return {hn::Sub(r, i), hn::Sub(g, j), hn::Sub(b, k), cell};
    }

  private:
    // NaN becomes 0.
    HWY_INLINE V held(V x) const {
        const V top = hn::Set(D(), top_), zero = hn::Zero(D());
        if constexpr (are_codes) {
            return hn::Min(x, top);
        } else if constexpr (HWY_ARCH_X86) {
            return hn::Min(hn::Max(x, zero), top); // of NaN and another the second
        } else {
            return hn::IfThenElseZero(hn::Gt(x, zero), hn::Min(x, top));
        }
    }
    HWY_INLINE V along(V v, std::size_t c) const {
        if constexpr (are_codes) {
            v = hn::Div(v, hn::Set(D(), maximum_));
        }
        if (tables_.shaper) {
            v = through_curve(*tables_.shaper, c, v);
        }
        return lattice_coordinate(v, tables_.domain.min[c], tables_.domain.max[c], tables_.size);
    }

    const GradeTables& tables_;
    float maximum_, top_;
};

/// Of a strip's pixels, in their order, four weights each; and where the nodes lie, in bytes, in
/// the order of transpose().
struct Found {
    HWY_ALIGN std::array<std::int32_t, strip> offset[2];
    HWY_ALIGN std::array<float, 4 * strip> weight[2];

    HWY_INLINE void put_weights(std::size_t set, std::size_t at, V a, V b, V c, V d) {
        transpose(a, b, c, d);
        float* const to = &weight[set][4 * at];
        hn::Store(a, D(), to);
        hn::Store(b, D(), to + lanes);
        hn::Store(c, D(), to + 2 * lanes);
        hn::Store(d, D(), to + 3 * lanes);
    }
};

/// Two pairs: the dark corner and the bright one; the two corners between, which are neighbours.
class TetrahedronPairs {
  public:
    static constexpr std::size_t pairs = 2;

    HWY_INLINE explicit TetrahedronPairs(const GradeTables& tables) : pairs_(tables.pairs()) {
        const int n = tables.size;
        const std::array<int, 3> step{1, n, n * n};
        for (std::size_t walk = 0; walk < tetrahedron_walks.size(); ++walk) {
            const auto first = tetrahedron_walks[walk][0], second = tetrahedron_walks[walk][1];
            step_[walk] = step[first] * static_cast<int>(GradeTables::pairs_bytes) +
                          static_cast<int>((1 + second) * 2 * GradeTables::node_bytes);
        }
    }
    HWY_INLINE void find(const Place& at, std::size_t i, Found& found) const {
        const D d;
        const DI di;
        const V high = hn::Max(at.r, at.g), low = hn::Min(at.r, at.g);
        const V middle = hn::Min(high, at.b);
        const V first = hn::Max(high, at.b), second = hn::Max(low, middle),
                third = hn::Min(low, middle);
        const auto rg = hn::RebindMask(di, hn::Ge(at.r, at.g));
        const auto gb = hn::RebindMask(di, hn::Ge(at.g, at.b));
        const auto rb = hn::RebindMask(di, hn::Ge(at.r, at.b));
        const auto step = [&](std::size_t walk) HWY_ATTR { return hn::Set(di, step_[walk]); };
        const VI red = hn::IfThenElse(gb, step(0), hn::IfThenElse(rb, step(1), step(4)));
        const VI green = hn::IfThenElse(rb, step(2), hn::IfThenElse(gb, step(3), step(5)));
        static_assert(GradeTables::pairs_bytes == 1 << 7);
        static_assert(GradeTables::largest_of_cells < 128, "cells are numbered below 2^21");
        const VI cell = hn::ShiftLeft<7>(nearest_whole(at.cell));
        hn::Store(cell, di, &found.offset[0][i]);
        hn::Store(hn::Add(cell, hn::IfThenElse(rg, red, green)), di, &found.offset[1][i]);
        found.put_weights(0, i, hn::Sub(hn::Set(d, 1), first), third, hn::Sub(first, second),
                          hn::Sub(second, third));
    }
    HWY_INLINE const float* pair(const Found& found, std::size_t k, std::size_t i) const {
        return reinterpret_cast<const float*>(pairs_ + found.offset[k][i]);
    }

  private:
    const std::byte* pairs_;
    std::array<int, 6> step_{};
};

/// Four pairs along red: all eight corners, of which a tetrahedron weighs four by 0.
class CubePairs {
  public:
    static constexpr std::size_t pairs = 4;

    HWY_INLINE explicit CubePairs(const GradeTables& tables)
        : is_tetrahedral_(tables.how == Interpolation::tetrahedral) {
        const auto n = static_cast<std::size_t>(tables.size);
        const std::size_t green = GradeTables::node_bytes * n;
        for (std::size_t k = 0; k < pairs; ++k) {
            row_[k] = tables.nodes() + (k % 2) * green + (k / 2) * green * n;
        }
    }
    HWY_INLINE void find(const Place& at, std::size_t i, Found& found) const {
        const D d;
        static_assert(GradeTables::node_bytes == 1 << 4);
        hn::Store(hn::ShiftLeft<4>(hn::ConvertTo(DI(), at.cell)), DI(), &found.offset[0][i]);
        const V one = hn::Set(d, 1), zero = hn::Zero(d);
        if (is_tetrahedral_) {
            const V rg = hn::Max(at.r, at.g), rb = hn::Max(at.r, at.b), gb = hn::Max(at.g, at.b);
            const V rg_low = hn::Min(at.r, at.g), rb_low = hn::Min(at.r, at.b),
                    gb_low = hn::Min(at.g, at.b);
            const auto above = [&](V a, V b) HWY_ATTR { return hn::Max(hn::Sub(a, b), zero); };
            found.put_weights(0, i, hn::Sub(one, hn::Max(rg, at.b)), above(at.r, gb),
                              above(at.g, rb), above(rg_low, at.b));
            found.put_weights(1, i, above(at.b, rg), above(rb_low, at.g), above(gb_low, at.r),
                              hn::Min(rg_low, at.b));
            return;
        }
        const V r = hn::Sub(one, at.r), g = hn::Sub(one, at.g), b = hn::Sub(one, at.b);
        const V dark = hn::Mul(g, b), green = hn::Mul(at.g, b), blue = hn::Mul(g, at.b),
                both = hn::Mul(at.g, at.b);
        found.put_weights(0, i, hn::Mul(r, dark), hn::Mul(at.r, dark), hn::Mul(r, green),
                          hn::Mul(at.r, green));
        found.put_weights(1, i, hn::Mul(r, blue), hn::Mul(at.r, blue), hn::Mul(r, both),
                          hn::Mul(at.r, both));
    }
    HWY_INLINE const float* pair(const Found& found, std::size_t k, std::size_t i) const {
        return reinterpret_cast<const float*>(row_[k] + found.offset[0][i]);
    }

  private:
    bool is_tetrahedral_;
    std::array<const std::byte*, pairs> row_;
};

/// The sums of `blocks` pixels. A vector holds half as many pairs: those of even pixels are summed
/// in one, those of odd pixels in another; at last the halves of pairs are added.
template <class Pairs>
class Sums {
  public:
    HWY_INLINE Sums() {
        if constexpr (blocks > 1) {
            for (std::size_t odd = 0; odd < 2; ++odd) {
                for (std::size_t k = 0; k < 2; ++k) {
                    HWY_ALIGN std::array<std::int32_t, most_lanes> from;
                    for (std::size_t i = 0; i < most_lanes; ++i) {
                        const std::size_t block = i / 4 % blocks;
                        from[i] = static_cast<std::int32_t>(4 * (block / 2 * 2 + odd) + 2 * k +
                                                            block % 2);
                    }
                    spread_[odd][k] = hn::SetTableIndices(D(), from.data());
                }
            }
        }
    }
    /// Of the pixels from `at` in the strip; `first`: of the lanes that transpose() gave them.
    HWY_INLINE V operator()(const Pairs& pairs, const Found& found, std::size_t at,
                            std::size_t first) const {
        if constexpr (blocks == 1) {
            return one_pixel(pairs, found, at, first);
        } else {
            const V even = half(pairs, found, at, first, 0), odd = half(pairs, found, at, first, 1);
            return hn::Add(hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd), even),
                           hn::OddEvenBlocks(odd, hn::SwapAdjacentBlocks(even)));
        }
    }

  private:
    static HWY_INLINE V one_pixel(const Pairs& pairs, const Found& found, std::size_t at,
                                  std::size_t first) {
        const D d;
        V sum = hn::Zero(d), other = hn::Zero(d);
        for (std::size_t k = 0; k < Pairs::pairs; ++k) {
            const float* const pair = pairs.pair(found, k, first);
            const float* const weight = &found.weight[k / 2][4 * at + 2 * (k % 2)];
            sum = hn::MulAdd(hn::LoadU(d, pair), hn::Set(d, weight[0]), sum);
            other = hn::MulAdd(hn::LoadU(d, pair + 4), hn::Set(d, weight[1]), other);
        }
        return hn::Add(sum, other);
    }
    HWY_INLINE V half(const Pairs& pairs, const Found& found, std::size_t at, std::size_t first,
                      std::size_t odd) const {
        const D d;
        V sum = hn::Zero(d);
        for (std::size_t k = 0; k < Pairs::pairs; ++k) {
            const V weights = hn::Load(d, &found.weight[k / 2][4 * at]);
            const V spread = hn::TableLookupLanes(weights, spread_[odd][k % 2]);
            const V nodes = load_pairs(pairs, found, k, first + 4 * odd);
            sum = k == 0 ? hn::Mul(nodes, spread) : hn::MulAdd(nodes, spread, sum);
        }
        return sum;
    }
    static HWY_INLINE V load_pairs(const Pairs& pairs, const Found& found, std::size_t k,
                                   std::size_t lane) {
        const D d;
        if constexpr (blocks == 2) {
            return hn::LoadU(d, pairs.pair(found, k, lane));
        } else {
            const hn::Half<D> half_d;
            return hn::Combine(d, hn::LoadU(half_d, pairs.pair(found, k, lane + 8)),
                               hn::LoadU(half_d, pairs.pair(found, k, lane)));
        }
    }

    using Indices = decltype(hn::SetTableIndices(D(), static_cast<const std::int32_t*>(nullptr)));
    Indices spread_[2][2];
};

/// `pixels`: whole vectors of as many pixels as a vector has floats.
template <class T, class Pairs>
void grade_by_pairs(const GradeTables& tables, const T* in, T* out, std::size_t pixels,
                    float maximum, bool streams) {
    // Asked for while sums are made, which wait least for memory; as far as measurement says.
    constexpr std::size_t ahead = 4096 / sizeof(T);
    const Places<std::is_integral_v<T>> places(tables, maximum);
    const Pairs pairs(tables);
    const Sums<Pairs> sums;
    const Store<T> store(maximum, streams, tables.least, tables.largest);
    Found found;
    for (std::size_t begin = 0; begin < pixels; begin += strip) {
        const std::size_t count = std::min(strip, pixels - begin);
        const T* const from = in + 4 * begin;
        T* const to = out + 4 * begin;
        for (std::size_t i = 0; i < count; i += lanes) {
            const T* const p = from + 4 * i;
            V r = load_samples(p), g = load_samples(p + lanes), b = load_samples(p + 2 * lanes),
              alpha = load_samples(p + 3 * lanes);
            transpose(r, g, b, alpha);
            pairs.find(places(r, g, b), i, found);
        }
        for (std::size_t i = 0; i < count; i += lanes) {
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t at = i + k * blocks;
                if (at % (16 / sizeof(T)) == 0) { // a line of the caches
                    hwy::Prefetch(from + 4 * at + ahead);
                }
                store(sums(pairs, found, at, i + k), from + 4 * at, to + 4 * at);
            }
        }
    }
}

#endif

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
