#include "lutlib/match/symmetric_product.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lutlib/match/symmetric_product.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The rows that a vector of this tag holds.
template <class D>
void rows(D d, const double* own, const Diagonal* diagonals, std::size_t count, const double* x,
          double* out, std::size_t k) {
    auto sum = hn::Mul(hn::LoadU(d, own + k), hn::LoadU(d, x + k));
    for (std::size_t i = 0; i < count; ++i) {
        const double* const entries = diagonals[i].entries + k;
        const std::ptrdiff_t offset = diagonals[i].offset;
        sum = hn::MulAdd(hn::LoadU(d, entries), hn::LoadU(d, x + k + offset), sum);
        sum = hn::MulAdd(hn::LoadU(d, entries - offset), hn::LoadU(d, x + k - offset), sum);
    }
    hn::StoreU(sum, d, out + k);
}

void SymmetricProduct(const double* own, const Diagonal* diagonals, std::size_t count,
                      const double* x, double* out, std::size_t first, std::size_t last) {
    const hn::ScalableTag<double> d;
    const hn::CappedTag<double, 1> one;
    const std::size_t lanes = hn::Lanes(d);
    std::size_t k = first;
    for (; k + lanes <= last; k += lanes) {
        rows(d, own, diagonals, count, x, out, k);
    }
    for (; k < last; ++k) {
        rows(one, own, diagonals, count, x, out, k);
    }
}

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace lutlib {
HWY_EXPORT(SymmetricProduct);

void symmetric_product(const double* own, std::span<const Diagonal> diagonals, const double* x,
                       double* out, std::size_t first, std::size_t last) {
    HWY_DYNAMIC_DISPATCH(SymmetricProduct)
    (own, diagonals.data(), diagonals.size(), x, out, first, last);
}

} // namespace lutlib

#endif
