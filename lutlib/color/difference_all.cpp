#include "lutlib/color/difference_all.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lutlib/color/difference_all.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include "lutlib/color/difference_constants.h"
#include "lutlib/color/powers.h"
#include "lutlib/color/rows/all.h"
#include "lutlib/color/transfer_constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

struct LabV {
    V L, a, b;
};

// CIEDE2000 as difference.cpp has it, but with directions instead of angles: sines and cosines of
// multiples of the mean hue follow from its own, and only the rotation term needs it in degrees.
class Ciede2000 {
  public:
    V operator()(const LabV& p, const LabV& q) const {
        const V mean_c = half(add(length(p.a, p.b), length(q.a, q.b)));
        const V stretch = sub(set(1.5), half(chroma_weight(mean_c)));
        const V a1 = mul(stretch, p.a), a2 = mul(stretch, q.a);
        const V c1 = length(a1, p.b), c2 = length(a2, q.b);
        const V product = mul(c1, c2);
        const auto neutral = hn::Eq(product, zero());

        // Unit vectors of both hues; of a neutral colour, which has none, nothing.
        const V x1 = share(a1, c1), y1 = share(p.b, c1), x2 = share(a2, c2), y2 = share(q.b, c2);
        const V sine = sub(mul(x1, y2), mul(x2, y1));
        const V cosine = add(mul(x1, x2), mul(y1, y2));
        const auto near = hn::Ge(cosine, zero());
        // Opposite hues turn as hues counted from 0 to 360 degrees do: away from 0.
        const auto lower =
            hn::Or(hn::Lt(y1, zero()), hn::And(hn::Eq(y1, zero()), hn::Lt(x1, zero())));
        const auto clockwise = hn::Or(hn::Lt(sine, zero()), hn::And(hn::Eq(sine, zero()), lower));
        // Each half-angle formula where it loses no digits.
        const V half_cosine = root(half(add(set(1), cosine)));
        const V half_sine_far = root(half(sub(set(1), cosine)));
        const V half_sine =
            hn::IfThenElse(near, hn::Div(half(sine), half_cosine),
                           hn::IfThenElse(clockwise, hn::Neg(half_sine_far), half_sine_far));
        const V dH = hn::IfThenZeroElse(neutral, mul(mul(set(2), root(product)), half_sine));

        // The bisector: the sum of both where they are near, else across their difference.
        const V dx = sub(x2, x1), dy = sub(y2, y1);
        const V across_x = hn::IfThenElse(clockwise, hn::Neg(dy), dy);
        const V across_y = hn::IfThenElse(clockwise, dx, hn::Neg(dx));
        const auto sum = hn::Or(near, neutral);
        const V bx = hn::IfThenElse(sum, add(x1, x2), across_x);
        const V by = hn::IfThenElse(sum, add(y1, y2), across_y);
        const V length_b = length(bx, by);
        const auto nowhere = hn::Eq(length_b, zero());
        const V x = hn::IfThenElse(nowhere, set(1), hn::Div(bx, length_b));
        const V y = hn::IfThenZeroElse(nowhere, hn::Div(by, length_b));

        const V dL = sub(q.L, p.L), dC = sub(c2, c1);
        const V mean_L = half(add(p.L, q.L)), mean_cp = half(add(c1, c2));
        const V lightness = sub(mean_L, set(50)), lightness_2 = mul(lightness, lightness);
        const V s_l =
            add(set(1), hn::Div(mul(set(0.015), lightness_2), root(add(set(20), lightness_2))));
        const V s_c = add(set(1), mul(set(0.045), mean_cp));
        const V s_h = add(set(1), mul(mul(set(0.015), mean_cp), hue_term(x, y)));
        const V r_t = mul(rotation(x, y), chroma_weight(mean_cp));
        const V l = hn::Div(dL, s_l), c = hn::Div(dC, s_c), h = hn::Div(dH, s_h);
        const V square = add(add(add(mul(l, l), mul(c, c)), mul(h, h)), mul(r_t, mul(c, h)));
        // The rotation term may leave a rounding error below zero for equal colours.
        return root(hn::Max(zero(), square));
    }

  private:
    static V set(double x) { return hn::Set(D(), x); }
    static V zero() { return hn::Zero(D()); }
    static V add(V a, V b) { return hn::Add(a, b); }
    static V sub(V a, V b) { return hn::Sub(a, b); }
    static V mul(V a, V b) { return hn::Mul(a, b); }
    static V half(V a) { return hn::Mul(a, set(0.5)); }
    static V root(V a) { return hn::Sqrt(a); }
    static V length(V a, V b) { return hn::Sqrt(hn::Add(hn::Mul(a, a), hn::Mul(b, b))); }
    static V share(V part, V whole) {
        return hn::IfThenZeroElse(hn::Eq(whole, zero()), hn::Div(part, whole));
    }

    static V chroma_weight(V c) {
        const V c2 = mul(c, c), c7 = mul(mul(c2, c2), mul(c2, c));
        return hn::Sqrt(hn::Div(c7, add(c7, set(6103515625.0)))); // 25^7
    }

    // cos(n h - turn) of a hue whose multiple has the given cosine and sine.
    static V turned(V cosine, V sine, double turn) {
        const double angle = turn * std::numbers::pi / 180;
        return add(mul(cosine, set(std::cos(angle))), mul(sine, set(std::sin(angle))));
    }

    static V hue_term(V x, V y) {
        const V cos_2 = sub(mul(x, x), mul(y, y)), sin_2 = mul(mul(set(2), x), y);
        const V cos_3 = sub(mul(cos_2, x), mul(sin_2, y)),
                sin_3 = add(mul(sin_2, x), mul(cos_2, y));
        const V cos_4 = sub(mul(cos_2, cos_2), mul(sin_2, sin_2));
        const V sin_4 = mul(mul(set(2), cos_2), sin_2);
        V t = sub(set(1), mul(set(0.17), turned(x, y, 30)));
        t = add(t, mul(set(0.24), cos_2));
        t = add(t, mul(set(0.32), turned(cos_3, sin_3, -6)));
        return sub(t, mul(set(0.20), turned(cos_4, sin_4, 63)));
    }

    // -2 sin(60 degrees * exp(-((h - 275) / 25)^2)).
    static V rotation(V x, V y) {
        constexpr double degree = std::numbers::pi / 180;
        const D d;
        // atan2 in 0..360: the arc tangent of the smaller part over the larger one.
        const V ax = hn::Abs(x), ay = hn::Abs(y);
        const V flat = hn::Atan(d, hn::Div(hn::Min(ax, ay), hn::Max(ax, ay)));
        const V first = hn::IfThenElse(hn::Gt(ay, ax), sub(set(std::numbers::pi / 2), flat), flat);
        const V upper = hn::IfThenElse(hn::Lt(x, zero()), sub(set(std::numbers::pi), first), first);
        const V angle =
            hn::IfThenElse(hn::Lt(y, zero()), sub(set(2 * std::numbers::pi), upper), upper);
        const V off = mul(sub(mul(angle, set(1 / degree)), set(275)), set(1.0 / 25));
        const V bell = hn::Exp(d, hn::Neg(mul(off, off)));
        return mul(set(-2), hn::Sin(d, mul(set(60 * degree), bell)));
    }
};

// The remainder goes through whole vectors, padded with black.
void DeltaE2000(const double* a, const double* b, double* out, std::size_t count) {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    const Ciede2000 distance;
    const auto at = [d, &distance](const double* p, const double* q) HWY_ATTR {
        LabV v, w;
        hn::LoadInterleaved3(d, p, v.L, v.a, v.b);
        hn::LoadInterleaved3(d, q, w.L, w.a, w.b);
        return distance(v, w);
    };
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        hn::StoreU(at(a + 3 * i, b + 3 * i), d, out + i);
    }
    if (i < count) {
        constexpr std::size_t most = HWY_MAX_BYTES / sizeof(double);
        HWY_ALIGN std::array<double, 3 * most> p{}, q{};
        HWY_ALIGN std::array<double, most> rest;
        std::copy(a + 3 * i, a + 3 * count, p.begin());
        std::copy(b + 3 * i, b + 3 * count, q.begin());
        hn::StoreU(at(p.data(), q.data()), d, rest.data());
        std::copy(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(count - i), out + i);
    }
}

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lutlib {
namespace {

// Of a Lab coordinate: beyond it, seventh powers overflow.
constexpr double largest_in_vectors = 1e30;
constexpr std::size_t piece = 128;

double largest(const Lab& c) {
    return largest_magnitude({c.L, c.a, c.b});
}

} // namespace

HWY_EXPORT(DeltaE2000);

void lab_from_linear_all(std::span<const RgbD> linear_rec709, std::span<Lab> out) {
    constexpr Matrix3 to_white =
        diagonal({1 / lab_white.r, 1 / lab_white.g, 1 / lab_white.b}) * rec709_to_xyz;
    std::array<RgbD, piece> share, roots;
    for (std::size_t first = 0; first < out.size(); first += piece) {
        const std::size_t count = std::min(piece, out.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            roots[i] = share[i] = to_white * linear_rec709[first + i];
        }
        cube_root_all({&roots[0].r, 3 * count});
        for (std::size_t i = 0; i < count; ++i) {
            const auto curve = [&](double t, double root) {
                return t > lab_cut ? root : t * lab_slope + lab_offset;
            };
            const double x = curve(share[i].r, roots[i].r), y = curve(share[i].g, roots[i].g),
                         z = curve(share[i].b, roots[i].b);
            out[first + i] = {116 * y - 16, 500 * (x - y), 200 * (y - z)};
        }
    }
}

void delta_e_2000_all(std::span<const Lab> a, std::span<const Lab> b, std::span<double> out) {
    static_assert(sizeof(Lab) == 3 * sizeof(double));
    if (out.empty()) {
        return;
    }
    HWY_DYNAMIC_DISPATCH(DeltaE2000)(&a[0].L, &b[0].L, out.data(), out.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (!(std::max(largest(a[i]), largest(b[i])) < largest_in_vectors)) {
            out[i] = delta_e_2000(a[i], b[i]);
        }
    }
}

void delta_e_itp_nits_all(std::span<const RgbD> rec2020_nits_a,
                          std::span<const RgbD> rec2020_nits_b, std::span<double> out) {
    std::array<RgbD, piece> p, q;
    const auto encode = [](std::span<const RgbD> nits, std::span<RgbD> to) {
        constexpr double per_white = 1 / pq_white_nits;
        for (std::size_t i = 0; i < nits.size(); ++i) {
            to[i] = per_white * (rec2020_to_lms * nits[i]);
        }
        curve::pq.encode_all(to);
    };
    for (std::size_t first = 0; first < out.size(); first += piece) {
        const std::size_t count = std::min(piece, out.size() - first);
        const auto from_a = rec2020_nits_a.subspan(first, count);
        const auto from_b = rec2020_nits_b.subspan(first, count);
        encode(from_a, std::span(p).first(count));
        encode(from_b, std::span(q).first(count));
        for (std::size_t i = 0; i < count; ++i) {
            const RgbD d = pq_lms_to_itp * (p[i] - q[i]);
            const bool finite = std::isfinite(largest_magnitude(from_a[i])) &&
                                std::isfinite(largest_magnitude(from_b[i]));
            out[first + i] = finite ? 720 * std::sqrt(d.r * d.r + d.g * d.g + d.b * d.b)
                                    : std::numeric_limits<double>::infinity();
        }
    }
}

} // namespace lutlib
#endif
