// Which nodes the pixels of a vector read and what they weigh: find() for all of them at once, at()
// sums for one.
// Compiled once for each instruction set, as apply.cpp is.
#if defined(LUTLIB_INTERPOLATION_LOOKUPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LUTLIB_INTERPOLATION_LOOKUPS_INL_H
#undef LUTLIB_INTERPOLATION_LOOKUPS_INL_H
#else
#define LUTLIB_INTERPOLATION_LOOKUPS_INL_H
#endif

#include "lutlib/interpolation/nodes-inl.h"
#include "lutlib/interpolation/stored_lut.h"

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Many pixels, a channel at a time.
using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
using DI = hn::RebindToSigned<D>;
using VI = hn::Vec<DI>;
constexpr std::size_t most_lanes = 16;

struct Colors {
    V r, g, b;
};

// In units of nodes, 0 .. size-1. The comparison's form sends NaN to 0.
HWY_INLINE V lattice_coordinate(V value, float min, float max, int size) {
    const D d;
    V t = value;
    if (min != 0 || max != 1) { // what this would do for 0 and 1 changes no bit
        t = hn::Div(hn::Sub(value, hn::Set(d, min)), hn::Set(d, max - min));
    }
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

template <class Fetch>
class Nearest {
  public:
    HWY_INLINE void find(const StoredLut& lut, const Colors& in) {
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

    HWY_INLINE Cell(const StoredLut& lut, const Colors& in) {
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

// The nodes from the dark corner to the bright one, along the axes in order of falling fraction.
struct Corners {
    VI offset[4];
    V weight[4];
};

struct Axis {
    V f;
    VI step;
};

HWY_INLINE void order(Axis& a, Axis& b) {
    const auto falls = hn::Ge(a.f, b.f);
    const auto falls_i = hn::RebindMask(DI(), falls);
    const Axis high{hn::IfThenElse(falls, a.f, b.f), hn::IfThenElse(falls_i, a.step, b.step)};
    b = {hn::IfThenElse(falls, b.f, a.f), hn::IfThenElse(falls_i, b.step, a.step)};
    a = high;
}

template <class Fetch>
HWY_INLINE Corners corners_of(const StoredLut& lut, const Colors& in) {
    const Cell<Fetch> cell(lut, in);
    const DI di;
    Axis x{cell.r.f, hn::Set(di, cell.dr)}, y{cell.g.f, hn::Set(di, cell.dg)},
        z{cell.b.f, hn::Set(di, cell.db)};
    order(x, y);
    order(y, z);
    order(x, y);
    const VI corner = cell.dark_corner();
    const VI first = hn::Add(corner, x.step), second = hn::Add(first, y.step);
    return {{corner, first, second, hn::Add(second, z.step)},
            {hn::Sub(hn::Set(D(), 1), x.f), hn::Sub(x.f, y.f), hn::Sub(y.f, z.f), z.f}};
}

template <class Fetch>
class Tetrahedral {
  public:
    HWY_INLINE void find(const StoredLut& lut, const Colors& in) {
        const Corners corners = corners_of<Fetch>(lut, in);
        for (std::size_t k = 0; k < 4; ++k) {
            hn::Store(corners.offset[k], DI(), reads_.offset[k].data());
            hn::Store(corners.weight[k], D(), reads_.weight[k].data());
        }
    }
    HWY_INLINE Pixel at(const std::uint8_t* nodes, std::size_t pixel) const {
        return term(nodes, 0, pixel) + term(nodes, 1, pixel) + term(nodes, 2, pixel) +
               term(nodes, 3, pixel);
    }

  private:
    HWY_INLINE Pixel term(const std::uint8_t* nodes, std::size_t k, std::size_t pixel) const {
        return Fetch::at(nodes + reads_.offset[k][pixel]) * reads_.weight[k][pixel];
    }

    Reads<4> reads_;
};

// With fractions in full, or rounded to so many bits.
template <class Fetch, int fraction_bits>
class Trilinear {
  public:
    HWY_INLINE void find(const StoredLut& lut, const Colors& in) {
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

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
