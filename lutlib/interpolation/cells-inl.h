// Tetrahedral interpolation of 8-bit pixels in whole numbers: a code's place between nodes is a
// multiple of 1/255, which 16 bits hold exactly, and one multiply-add weighs two nodes that lie
// side by side. Compiled once for each instruction set, as grade_kernels.cpp is.
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
using VU32 = hn::Vec<DU32>;
using VU16 = hn::Vec<DU16>;
using VI16 = hn::Vec<DI16>;
using VU8 = hn::Vec<DU8>;

/// a0 b0 + a1 b1 of every two neighbours.
HWY_INLINE VI dot_pairs(VI16 a, VI16 b) {
    VI rest = hn::Zero(DI());
    const VI sum = hn::ReorderWidenMulAccumulate(DI(), a, b, hn::Zero(DI()), rest);
    return hn::Add(sum, rest); // some processors leave a part in each
}

/// Of a strip's pixels, in their order, for each of their two pairs of nodes: where it lies, in
/// half pairs, and what the two weigh, in the lower and in the upper half.
struct FoundCells {
    HWY_ALIGN std::array<std::int32_t, strip> offset[2];
    HWY_ALIGN std::array<std::uint32_t, strip> weights[2];
};

class Cells {
  public:
    HWY_INLINE explicit Cells(const GradeTables& tables)
        : cells_(tables.cells()), size_(static_cast<std::uint32_t>(tables.size)) {
        const std::uint32_t step[3] = {1, size_, size_ * size_};
        for (std::uint32_t c = 0; c < 3; ++c) {
            step_[c] = halves_of_a_cell * step[c] | 2 * (c + 1);
        }
    }

    /// Of as many pixels as a vector has floats, in their order.
    HWY_INLINE void find(const std::uint8_t* in, std::size_t i, FoundCells& found) const {
        const DU32 d;
        const DI16 s16;
        const VU32 pixels = hn::LoadU(d, reinterpret_cast<const std::uint32_t*>(in));
        const Axis rb = locate(hn::And(pixels, hn::Set(d, 0x00FF00FF)));
        const Axis g = locate(hn::And(hn::ShiftLeft<8>(pixels), hn::Set(d, 0x00FF0000)));
        const auto steps = [&](std::uint32_t two)
                               HWY_ATTR { return hn::BitCast(s16, hn::Set(d, two)); };
        const VI cell = hn::Add(dot_pairs(hn::BitCast(s16, rb.i), steps(size_ * size_ << 16 | 1)),
                                dot_pairs(hn::BitCast(s16, g.i), steps(size_ << 16)));
        static_assert(halves_of_a_cell == 1 << 3);
        put(hn::ShiftLeft<3>(cell), rb.f, g.f, i, found);
    }

    /// Of every fourth pixel of the vector that begins at `at`, from its `first` on, a block each:
    /// what its nodes come to, so weighed.
    template <int first>
    HWY_INLINE VI sums(const FoundCells& found, std::size_t at) const {
        return hn::Add(pair_sums<first>(found, 0, at), pair_sums<first>(found, 1, at));
    }

  private:
    struct Axis {
        VU32 i, f; ///< the node below, and how many 255ths beyond it, of each half
    };
    static constexpr std::size_t half_pair = 8; ///< bytes
    static constexpr std::uint32_t halves_of_a_cell = GradeTables::cell_bytes / half_pair;

    // Dividing by 255 as a multiplication, exact for 16 bits.
    HWY_INLINE Axis locate(VU32 codes) const {
        const DU32 d;
        const DU16 d16;
        const VU16 place =
            hn::Mul(hn::BitCast(d16, codes), hn::Set(d16, static_cast<std::uint16_t>(size_ - 1)));
        const VU16 i = hn::ShiftRight<7>(hn::MulHigh(place, hn::Set(d16, 0x8081)));
        const VU16 f = hn::And(hn::Add(place, i), hn::Set(d16, 255)); // place is 256 i - i + f
        return {hn::BitCast(d, i), hn::BitCast(d, f)};
    }

    // Fractions, in the upper halves, are sorted with their axes behind them: the step to the next
    // node along it, and which pair of a node goes along it. `rb`: red, and blue above it; `g`:
    // green above 0.
    HWY_INLINE void put(VI cell, VU32 rb, VU32 g, std::size_t i, FoundCells& found) const {
        const DU32 d;
        const VU32 upper = hn::Set(d, 0xFFFF0000);
        const VU32 red = hn::Or(hn::ShiftLeft<16>(rb), hn::Set(d, step_[0]));
        const VU32 green = hn::Or(g, hn::Set(d, step_[1]));
        const VU32 blue = hn::IfVecThenElse(upper, rb, hn::Set(d, step_[2]));
        const VU32 high = hn::Max(red, green), low = hn::Min(red, green);
        const VU32 middle = hn::Min(high, blue);
        const VU32 first = hn::Max(high, blue), second = hn::Max(low, middle),
                   third = hn::Min(low, middle);

        constexpr std::uint32_t in_cell = halves_of_a_cell - 1;
        const VU32 next_node = hn::And(first, hn::Set(d, 0xFFFF - in_cell));
        const VU32 pair = hn::OrAnd(next_node, second, hn::Set(d, in_cell));
        hn::Store(cell, DI(), &found.offset[0][i]);
        hn::Store(hn::Add(cell, hn::BitCast(DI(), pair)), DI(), &found.offset[1][i]);

        const VU32 falling = hn::IfVecThenElse(upper, second, hn::ShiftRight<16>(first));
        const VU32 next = hn::IfVecThenElse(upper, third, hn::ShiftRight<16>(second));
        const auto less = [](VU32 a, VU32 b) HWY_ATTR {
            return hn::BitCast(DU32(), hn::Sub(hn::BitCast(DU16(), a), hn::BitCast(DU16(), b)));
        };
        const VU32 whole = hn::Set(d, GradeTables::whole);
        hn::Store(hn::IfVecThenElse(upper, next, less(whole, falling)), d, &found.weights[0][i]);
        hn::Store(less(falling, next), d, &found.weights[1][i]);
    }

    template <int first>
    HWY_INLINE VI pair_sums(const FoundCells& found, std::size_t k, std::size_t at) const {
        const DU32 d;
        const VU32 weights = hn::Broadcast<first>(hn::Load(d, &found.weights[k][at]));
        return dot_pairs(hn::BitCast(DI16(), weights), every_fourth(&found.offset[k][at + first]));
    }

    HWY_INLINE VI16 every_fourth(const std::int32_t* offset) const {
        const DI16 d;
        const auto pair = [&](std::size_t block) HWY_ATTR {
            return reinterpret_cast<const std::int16_t*>(
                cells_ + half_pair * static_cast<std::size_t>(offset[4 * block]));
        };
        if constexpr (blocks == 1) {
            return hn::Load(d, pair(0));
        } else if constexpr (blocks == 2) {
            const hn::Half<DI16> half;
            return hn::Combine(d, hn::Load(half, pair(1)), hn::Load(half, pair(0)));
        } else {
            VI16 out = hn::LoadDup128(d, pair(3));
            for (std::size_t block = 3; block-- > 0;) {
                out = hn::IfThenElse(hn::FirstN(d, 8 * (block + 1)), hn::LoadDup128(d, pair(block)),
                                     out);
            }
            return out;
        }
    }

    const std::byte* cells_;
    std::uint32_t size_;
    std::array<std::uint32_t, 3> step_{};
};

/// Codes of sums of nodes within 0..1, four of each block of `a`, `b`, `c` and `e` in the block.
HWY_INLINE VU8 codes_within(VI a, VI b, VI c, VI e) {
    // The code and a half, times 2^16, less 2^23: its third byte, but for the uppermost bit.
    static_assert(GradeTables::cell_bits_within == 16 && GradeTables::whole == 255);
    const DU32 d;
    const DU8 d8;
    const auto of = [&](VI sum) HWY_ATTR { return hn::BitCast(d, sum); };
    const VU32 ab =
        hn::IfVecThenElse(hn::Set(d, 0x00FF), hn::ShiftRight<16>(of(a)), hn::ShiftRight<8>(of(b)));
    const VU32 ce = hn::IfVecThenElse(hn::Set(d, 0x00FF0000), of(c), hn::ShiftLeft<8>(of(e)));
    const VU32 all = hn::IfVecThenElse(hn::Set(d, 0xFFFF), ab, ce);
    HWY_ALIGN std::array<std::uint8_t, 64> from;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::size_t to = i % 16;
        from[i] = static_cast<std::uint8_t>(to % 4 * 4 + to / 4);
    }
    const VU8 bytes = hn::TableLookupBytes(hn::BitCast(d8, all), hn::Load(d8, from.data()));
    return hn::Xor(bytes, hn::Set(d8, 0x80));
}

/// The same of any nodes, held to 0..255.
HWY_INLINE VU8 codes_held(VI a, VI b, VI c, VI e, std::int32_t bias) {
    const DI16 d;
    HWY_ALIGN std::array<std::uint8_t, 64> from;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const std::size_t to = i % 16;
        from[i] = static_cast<std::uint8_t>(to / 4 % 2 * 8 + to % 4 * 2 + to / 8);
    }
    const auto code = [&](VI sum) HWY_ATTR {
        return hn::ShiftRight<GradeTables::cell_bits_beyond>(hn::Add(sum, hn::Set(DI(), bias)));
    };
    const auto held = [&](VI first, VI second) HWY_ATTR {
        const VI16 both = hn::ReorderDemote2To(d, code(first), code(second));
        return hn::BitCast(DU16(), hn::Min(hn::Max(both, hn::Zero(d)), hn::Set(d, 255)));
    };
    const VU16 bytes = hn::Or(held(a, b), hn::ShiftLeft<8>(held(c, e)));
    return hn::TableLookupBytes(hn::BitCast(DU8(), bytes), hn::Load(DU8(), from.data()));
}

/// `pixels`: whole vectors of as many pixels as a vector has floats. `is_within`: no node lies
/// outside 0..1.
template <bool is_within>
HWY_INLINE void grade_by_cells(const GradeTables& tables, const std::uint8_t* in, std::uint8_t* out,
                               std::size_t pixels, bool streams) {
    constexpr std::size_t ahead = 4096;
    const DU8 d;
    const Cells cells(tables);
    const std::int32_t bias = tables.cell_bias();
    const VU8 alphas = hn::BitCast(d, hn::Set(DU32(), 0xFF000000));
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
            const VI a = cells.sums<0>(found, i), b = cells.sums<1>(found, i),
                     c = cells.sums<2>(found, i), e = cells.sums<3>(found, i);
            VU8 codes;
            if constexpr (is_within) {
                codes = codes_within(a, b, c, e);
            } else {
                codes = codes_held(a, b, c, e, bias);
            }
            const VU8 both = hn::IfVecThenElse(alphas, hn::LoadU(d, from + 4 * i), codes);
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
