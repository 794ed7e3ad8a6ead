// Sums of several pixels side by side: a vector holds as many pixels of four floats as it has
// blocks of 128 bits. Each block loads its pixel's nodes, so that nothing has to be gathered.
// Compiled once for each instruction set, as apply.cpp is.
#if defined(LUTLIB_INTERPOLATION_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LUTLIB_INTERPOLATION_BLOCKS_INL_H
#undef LUTLIB_INTERPOLATION_BLOCKS_INL_H
#else
#define LUTLIB_INTERPOLATION_BLOCKS_INL_H
#endif

#include "lutlib/interpolation/lookups-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

// A vector of D has the numbers of four vectors of such blocks.
constexpr std::size_t blocks = hn::MaxLanes(D()) / 4;
constexpr std::size_t groups = 4;

/// Repeats the number of each of a group's pixels over its block.
class Spread {
  public:
    HWY_INLINE explicit Spread(std::size_t group) {
        HWY_ALIGN std::array<std::int32_t, most_lanes> from;
        for (std::size_t i = 0; i < most_lanes; ++i) {
            from[i] = static_cast<std::int32_t>(group * blocks + i / 4 % blocks);
        }
        from_ = hn::SetTableIndices(D(), from.data());
    }
    HWY_INLINE V operator()(V numbers) const { return hn::TableLookupLanes(numbers, from_); }

  private:
    decltype(hn::SetTableIndices(D(), static_cast<const std::int32_t*>(nullptr))) from_;
};

/// A node of each pixel of a group; the nodes are 16 bytes each, aligned.
template <std::size_t count = blocks>
HWY_INLINE V nodes_at(const std::uint8_t* nodes, const std::int32_t* offset) {
    const auto node = [&](std::size_t i) HWY_ATTR {
        return hn::Load(D4(), reinterpret_cast<const float*>(nodes + offset[i]));
    };
    if constexpr (count == 1) {
        return node(0);
    } else if constexpr (count == 2) {
        return hn::Combine(D(), node(1), node(0));
    } else {
        const hn::Half<D> d;
        return hn::Combine(D(), hn::Combine(d, node(3), node(2)), hn::Combine(d, node(1), node(0)));
    }
}

class TetrahedralBlocks {
  public:
    HWY_INLINE void find(const StoredLut& lut, const Colours& in) {
        const Corners corners = corners_of<Floats>(lut, in);
        for (std::size_t k = 0; k < 4; ++k) {
            hn::Store(corners.offset[k], DI(), offset_[k].data());
            weight_[k] = corners.weight[k];
        }
    }
    HWY_INLINE V at(const std::uint8_t* nodes, std::size_t group, const Spread& spread) const {
        const auto term = [&](std::size_t k) HWY_ATTR {
            return hn::Mul(nodes_at(nodes, &offset_[k][group * blocks]), spread(weight_[k]));
        };
        return hn::Add(hn::Add(hn::Add(term(0), term(1)), term(2)), term(3));
    }

  private:
    HWY_ALIGN std::array<std::array<std::int32_t, most_lanes>, 4> offset_;
    V weight_[4];
};

class TrilinearBlocks {
  public:
    HWY_INLINE void find(const StoredLut& lut, const Colours& in) {
        const Cell<Floats> cell(lut, in);
        dg_ = cell.dg;
        db_ = cell.db;
        hn::Store(cell.dark_corner(), DI(), offset_.data());
        fraction_[0] = cell.r.f;
        fraction_[1] = cell.g.f;
        fraction_[2] = cell.b.f;
    }
    HWY_INLINE V at(const std::uint8_t* nodes, std::size_t group, const Spread& spread) const {
        const V one = hn::Set(D(), 1);
        V high[3], low[3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            high[axis] = spread(fraction_[axis]);
            low[axis] = hn::Sub(one, high[axis]);
        }
        const std::int32_t* const offset = &offset_[group * blocks];
        const auto mix = [&](V a, V b, std::size_t axis) HWY_ATTR {
            return hn::Add(hn::Mul(a, low[axis]), hn::Mul(b, high[axis]));
        };
        const auto row = [&](std::ptrdiff_t at) HWY_ATTR {
            const std::uint8_t* const first = nodes + at;
            return mix(nodes_at(first, offset), nodes_at(first + Floats::bytes, offset), 0);
        };
        return mix(mix(row(0), row(dg_), 1), mix(row(db_), row(db_ + dg_), 1), 2);
    }

  private:
    HWY_ALIGN std::array<std::int32_t, most_lanes> offset_;
    V fraction_[3];
    std::ptrdiff_t dg_ = 0, db_ = 0;
};

#endif

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
