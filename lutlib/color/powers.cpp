#include "lutlib/color/powers.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lutlib/color/powers.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

// The remainder goes through a whole vector, padded with ones.
template <class F>
void each(double* values, std::size_t count, F f) {
    const D d;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        hn::StoreU(f(d, hn::LoadU(d, values + i)), d, values + i);
    }
    if (i < count) {
        HWY_ALIGN double rest[HWY_MAX_BYTES / sizeof(double)];
        for (std::size_t k = 0; k < lanes; ++k) {
            rest[k] = i + k < count ? values[i + k] : 1;
        }
        hn::Store(f(d, hn::Load(d, rest)), d, rest);
        for (std::size_t k = 0; i + k < count; ++k) {
            values[i + k] = rest[k];
        }
    }
}

V clamped_exp(D d, V x) {
    return hn::Exp(d, hn::Min(hn::Max(x, hn::Set(d, -700.0)), hn::Set(d, 700.0)));
}

V clamped_log(D d, V x) {
    return hn::Log(d, hn::Max(x, hn::Set(d, 1e-300)));
}

void Power(double* values, std::size_t count, double exponent) {
    each(values, count, [exponent](D d, V x) HWY_ATTR {
        const V a = hn::Abs(x);
        const V y = clamped_exp(d, hn::Mul(clamped_log(d, a), hn::Set(d, exponent)));
        return hn::IfThenZeroElse(hn::Eq(a, hn::Zero(d)), y);
    });
}

void CubeRoot(double* values, std::size_t count) {
    each(values, count, [](D d, V x) HWY_ATTR {
        const V a = hn::Abs(x);
        const V third = hn::Set(d, 1.0 / 3);
        const V y = clamped_exp(d, hn::Mul(clamped_log(d, a), third));
        // One step of Newton's method takes the error of the logarithm away.
        const V better = hn::Mul(third, hn::Add(hn::Add(y, y), hn::Div(a, hn::Mul(y, y))));
        return hn::CopySign(hn::IfThenZeroElse(hn::Eq(a, hn::Zero(d)), better), x);
    });
}

void Exponential(double* values, std::size_t count) {
    each(values, count, [](D d, V x) HWY_ATTR { return clamped_exp(d, x); });
}

void Logarithm(double* values, std::size_t count) {
    each(values, count, [](D d, V x) HWY_ATTR { return clamped_log(d, x); });
}

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lutlib {

HWY_EXPORT(Power);
HWY_EXPORT(CubeRoot);
HWY_EXPORT(Exponential);
HWY_EXPORT(Logarithm);

void power_all(std::span<double> values, double exponent) {
    HWY_DYNAMIC_DISPATCH(Power)(values.data(), values.size(), exponent);
}

void power_all(std::span<RgbD> colors, RgbD exponents, Negative negative) {
    std::array<double, 128> room;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < colors.size() && exponents[c] != 1; i += room.size()) {
            const auto part = colors.subspan(i, std::min(room.size(), colors.size() - i));
            for (std::size_t k = 0; k < part.size(); ++k) {
                room[k] = part[k][c];
            }
            power_all(std::span(room).first(part.size()), exponents[c]);
            for (std::size_t k = 0; k < part.size(); ++k) {
                double& x = part[k][c];
                x = x < 0 && negative == Negative::kept ? x : std::copysign(room[k], x);
            }
        }
    }
}

void cube_root_all(std::span<double> values) {
    HWY_DYNAMIC_DISPATCH(CubeRoot)(values.data(), values.size());
}

void exp_all(std::span<double> values) {
    HWY_DYNAMIC_DISPATCH(Exponential)(values.data(), values.size());
}

void log_all(std::span<double> values) {
    HWY_DYNAMIC_DISPATCH(Logarithm)(values.data(), values.size());
}

} // namespace lutlib
#endif
