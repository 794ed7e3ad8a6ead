// Tetrahedral interpolation of 8-bit pixels in whole numbers: a code's place between nodes is a
// multiple of 1/255, which 16 bits hold exactly; each cell keeps its eight corners in one line of
// the caches, which one multiply-add weighs, four by 0. Compiled once for each instruction set, as
// grade_kernels.cpp is.
#if defined(LUTLIB_INTERPOLATION_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LUTLIB_INTERPOLATION_CELLS_INL_H
#undef LUTLIB_INTERPOLATION_CELLS_INL_H
#else
#define LUTLIB_INTERPOLATION_CELLS_INL_H
#endif

#include "lutlib/interpolation/pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

using DU32 = hn::RebindToUnsigned<D>;
using DU16 = hn::Repartition<std::uint16_t, D>;
using DI16 = hn::Repartition<std::int16_t, D>;
using DU8 = hn::Repartition<std::uint8_t, D>;
using VU16 = hn::Vec<DU16>;

/// a0 b0 + a1 b1 of every two neighbours.
HWY_INLINE VI dot_pairs(hn::Vec<DI16> a, hn::Vec<DI16> b) {
    VI rest = hn::Zero(DI());
    const VI sum = hn::ReorderWidenMulAccumulate(DI(), a, b, hn::Zero(DI()), rest);
    return hn::Add(sum, rest); // some processors leave a part in each
}

/// Of a strip's pixels, in their order: the cell's offset in bytes and four pairs of weights.
struct FoundCells {
    HWY_ALIGN std::array<std::int32_t, strip> offset;
    HWY_ALIGN std::array<std::int16_t, 8 * strip> weight;
};

class Cells {
  public:
    HWY_INLINE explicit Cells(const GradeTables& tables)
        : cells_(tables.cells()), size_(tables.size), factor_(tables.cell_factor()),
          offset_(tables.cell_offset()) {
        HWY_ALIGN std::array<std::uint8_t, 64> from;
        for (std::size_t i = 0; i < from.size(); ++i) {
            from[i] = static_cast<std::uint8_t>(i / 16 % blocks * 4 + i % 4);
        }
        spread_ = hn::Load(DU8(), from.data());
    }

    /// Of as many pixels as a vector has floats, in their order.
    HWY_INLINE void find(const std::uint8_t* in, std::size_t i, FoundCells& found) const {
        const DU32 d;
        const DU16 d16;
        const DI16 s16;
        const auto pixels = hn::LoadU(d, reinterpret_cast<const std::uint32_t*>(in));
        const Axis rb = locate(hn::BitCast(d16, hn::And(pixels, hn::Set(d, 0x00FF00FF))));
        const Axis g =
            locate(hn::BitCast(d16, hn::And(hn::ShiftRight<8>(pixels), hn::Set(d, 0x000000FF))));
        const auto n = static_cast<std::uint32_t>(size_);
        const auto rb_steps = hn::BitCast(s16, hn::Set(d, n * n << 16 | 1));
        const VI cell = hn::Add(dot_pairs(hn::BitCast(s16, rb.i), rb_steps),
                                dot_pairs(hn::BitCast(s16, g.i), hn::BitCast(s16, hn::Set(d, n))));
        static_assert(GradeTables::cell_bytes == 1 << 6);
        hn::Store(hn::ShiftLeft<6>(cell), DI(), &found.offset[i]);
        put_weights(rb.f, g.f, i, found);
    }

    /// The codes of every fourth pixel of the vector that begins at `at`, from its `first` on.
    template <std::size_t first>
    HWY_INLINE VI codes(const FoundCells& found, std::size_t at) const {
        const D d;
        VI sum;
        if constexpr (blocks == 1) {
            sum = one_sum<first>(found, at);
        } else if constexpr (blocks == 2) {
            const VI a = one_sum<first>(found, at), b = one_sum<first + 4>(found, at);
            sum = hn::Add(hn::ConcatLowerLower(DI(), b, a), hn::ConcatUpperUpper(DI(), b, a));
        } else {
            // Quarters of two sums, added crosswise, then of four.
            const VI a = halved(one_sum<first>(found, at), one_sum<first + 8>(found, at));
            const VI b = halved(one_sum<first + 4>(found, at), one_sum<first + 12>(found, at));
            sum = hn::Add(hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a),
                          hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a)));
        }
        return nearest_whole(
            hn::MulAdd(hn::ConvertTo(d, sum), hn::Set(d, factor_), hn::Set(d, offset_)));
    }

  private:
    struct Axis {
        VU16 i, f; ///< the node below, and 128 times how many 255ths beyond it
    };

    // Dividing by 255 as a multiplication, exact for 16 bits.
    HWY_INLINE Axis locate(VU16 codes) const {
        const DU16 d;
        const VU16 place = hn::Mul(codes, hn::Set(d, static_cast<std::uint16_t>(size_ - 1)));
        const VU16 i = hn::ShiftRight<7>(hn::MulHigh(place, hn::Set(d, 0x8081)));
        return {i, hn::ShiftLeft<7>(hn::Sub(place, hn::Mul(i, hn::Set(d, 255))))};
    }

    // `rb`: red and blue of a pixel side by side; `g`: green and 0.
    static HWY_INLINE void put_weights(VU16 rb, VU16 g, std::size_t i, FoundCells& found) {
        const DU16 d;
        const DU32 pairs;
        const auto green = hn::BitCast(pairs, g);
        const VU16 gg = hn::BitCast(d, hn::Or(green, hn::ShiftLeft<16>(green)));
        const VU16 br = hn::Reverse2(d, rb);
        const VU16 high = hn::Max(rb, gg), low = hn::Min(rb, gg);
        const VU16 rb_high = hn::Max(rb, br), rb_low = hn::Min(rb, br);
        const VU16 least = hn::Min(rb_low, gg), most = hn::Max(rb_high, gg);
        const VU16 whole = hn::Set(d, static_cast<std::uint16_t>(GradeTables::whole));
        // In the order of GradeTables::cell_bytes.
        const auto as_floats = [](VU16 v) HWY_ATTR { return hn::BitCast(D(), v); };
        V a = as_floats(hn::OddEven(least, hn::Sub(whole, most)));
        V b = as_floats(hn::SaturatedSub(rb, hn::Reverse2(d, high)));
        V c = as_floats(hn::SaturatedSub(low, br));
        V e = as_floats(hn::SaturatedSub(hn::OddEven(rb_low, gg), hn::OddEven(gg, rb_high)));
        transpose(a, b, c, e);
        // Pixel 4 j + k lies in block j of the k-th.
        const V of[4] = {a, b, c, e};
        for (std::size_t k = 0; k < 4; ++k) {
            hn::Store(of[k], D(), reinterpret_cast<float*>(&found.weight[8 * (i + k * blocks)]));
        }
    }

    // Sums of pairs of corners: in each block of the vector those that it holds.
    template <std::size_t pixel>
    HWY_INLINE VI one_sum(const FoundCells& found, std::size_t at) const {
        const DI16 d;
        const std::int16_t* const weight = &found.weight[8 * (at + pixel % 4 * blocks + pixel / 4)];
        const auto* const cell =
            reinterpret_cast<const std::int16_t*>(cells_ + found.offset[at + pixel]);
        if constexpr (blocks == 1) {
            const auto weights = hn::Load(DI(), reinterpret_cast<const std::int32_t*>(weight));
            const auto term = [&](std::size_t k, auto spread) HWY_ATTR {
                return dot_pairs(hn::BitCast(d, spread), hn::Load(d, cell + 8 * k));
            };
            return hn::Add(
                hn::Add(term(0, hn::Broadcast<0>(weights)), term(1, hn::Broadcast<1>(weights))),
                hn::Add(term(2, hn::Broadcast<2>(weights)), term(3, hn::Broadcast<3>(weights))));
        } else {
            const auto weights = hn::LoadDup128(d, weight);
            const auto spread = [&](auto from) HWY_ATTR {
                return hn::BitCast(d, hn::TableLookupBytes(hn::BitCast(DU8(), weights), from));
            };
            const VI sum = dot_pairs(spread(spread_), hn::Load(d, cell));
            if constexpr (blocks == 2) {
                const auto second = hn::Add(spread_, hn::Set(DU8(), 8));
                return hn::Add(sum, dot_pairs(spread(second), hn::Load(d, cell + 16)));
            } else {
                return sum;
            }
        }
    }

    // Blocks 0 and 2, 1 and 3 of each added: those of `a`, then those of `b`.
    static HWY_INLINE VI halved(VI a, VI b) {
        return hn::Add(hn::ConcatLowerLower(DI(), b, a), hn::ConcatUpperUpper(DI(), b, a));
    }

    const std::byte* cells_;
    int size_;
    float factor_, offset_;
    hn::Vec<DU8> spread_;
};

/// Held to 0..255: four bytes of each block of `a`, then of `b`, `c` and `e`, in the block.
HWY_INLINE hn::Vec<DU8> as_bytes(VI a, VI b, VI c, VI e) {
    const DI16 d;
    HWY_ALIGN std::array<std::uint8_t, 64> from;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::size_t to = i % 16;
        from[i] = static_cast<std::uint8_t>(to / 4 % 2 * 8 + to % 4 * 2 + to / 8);
    }
    const auto held = [&](VI first, VI second) HWY_ATTR {
        const auto both = hn::ReorderDemote2To(d, first, second);
        return hn::BitCast(DU16(), hn::Min(hn::Max(both, hn::Zero(d)), hn::Set(d, 255)));
    };
    const VU16 bytes = hn::Or(held(a, b), hn::ShiftLeft<8>(held(c, e)));
    return hn::TableLookupBytes(hn::BitCast(DU8(), bytes), hn::Load(DU8(), from.data()));
}

/// `pixels`: whole vectors of as many pixels as a vector has floats.
HWY_INLINE void grade_by_cells(const GradeTables& tables, const std::uint8_t* in, std::uint8_t* out,
                               std::size_t pixels, bool streams) {
    constexpr std::size_t ahead = 4096;
    const DU8 d;
    const Cells cells(tables);
    const auto alphas = hn::BitCast(d, hn::Set(DU32(), 0xFF000000));
    FoundCells found;
    for (std::size_t begin = 0; begin < pixels; begin += strip) {
        const std::size_t count = std::min(strip, pixels - begin);
        const std::uint8_t* const from = in + 4 * begin;
        std::uint8_t* const to = out + 4 * begin;
        for (std::size_t i = 0; i < count; i += lanes) {
            cells.find(from + 4 * i, i, found);
        }
        for (std::size_t i = 0; i < count; i += lanes) {
            hwy::Prefetch(from + ahead + 4 * i);
            const auto codes = as_bytes(cells.codes<0>(found, i), cells.codes<1>(found, i),
                                        cells.codes<2>(found, i), cells.codes<3>(found, i));
            const auto both =
                hn::Or(hn::And(alphas, hn::LoadU(d, from + 4 * i)), hn::AndNot(alphas, codes));
            if (streams) {
                hn::Stream(both, d, to + 4 * i);
            } else {
                hn::StoreU(both, d, to + 4 * i);
            }
        }
    }
}

#endif

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
