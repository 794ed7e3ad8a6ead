#include "lutlib/interpolation/grade_tables.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lutlib/interpolation/grade_kernels.cpp"
#include <hwy/foreach_target.h>

#include "lutlib/interpolation/cells-inl.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/interpolation/pairs-inl.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
// Highway's last resort has vectors of one number only: a pixel at a time, of floats.
void Grade(const GradeTables& tables, Element, const std::byte* in, std::byte* out,
           std::size_t pixels, bool) {
    for (std::size_t i = 0; i < pixels; ++i) {
        std::array<float, 4> p;
        std::memcpy(p.data(), in + i * sizeof p, sizeof p);
        RgbD color = to_double({p[0], p[1], p[2]});
        if (tables.shaper) {
            color = evaluate_exact(*tables.shaper, color);
        }
        if (tables.size > 0) {
            color = weighed_nodes(tables, color);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            p[c] = static_cast<float>(color[c]);
        }
        std::memcpy(out + i * sizeof p, p.data(), sizeof p);
    }
}

bool HasKernel(Element element) {
    return element == Element::float32;
}
#else

// Through the 1D table alone.
void grade_by_curves(const GradeTables& tables, const float* in, float* out, std::size_t pixels,
                     bool streams) {
    const Store<float> store(1, streams, 0, 1);
    const Lut1D& curve = *tables.shaper;
    for (std::size_t i = 0; i < 4 * pixels; i += 4 * lanes) {
        const float* const p = in + i;
        V c[4] = {load_samples(p), load_samples(p + lanes), load_samples(p + 2 * lanes),
                  load_samples(p + 3 * lanes)};
        transpose(c[0], c[1], c[2], c[3]);
        for (std::size_t k = 0; k < 3; ++k) {
            c[k] = through_curve(curve, k, c[k]);
        }
        transpose(c[0], c[1], c[2], c[3]);
        for (std::size_t k = 0; k < 4; ++k) {
            store(c[k], p + k * lanes, out + i + k * lanes);
        }
    }
}

// Whole vectors of as many pixels as a vector has floats.
template <class T>
void grade_vectors(const GradeTables& tables, const T* in, T* out, std::size_t pixels,
                   float maximum, bool streams) {
    if constexpr (std::is_same_v<T, float>) {
        if (tables.size == 0) {
            return grade_by_curves(tables, in, out, pixels, streams);
        }
    }
    if constexpr (std::is_same_v<T, std::uint8_t>) {
        if (tables.cells()) {
            return tables.is_within() ? grade_by_cells<true>(tables, in, out, pixels, streams)
                                      : grade_by_cells<false>(tables, in, out, pixels, streams);
        }
    }
    return tables.pairs()
               ? grade_by_pairs<T, TetrahedronPairs>(tables, in, out, pixels, maximum, streams)
               : grade_by_pairs<T, CubePairs>(tables, in, out, pixels, maximum, streams);
}

template <class T>
bool is_of_one_color(const T* pixels, std::size_t count) {
    return std::memcmp(pixels, pixels + 4, (count - 1) * 4 * sizeof(T)) == 0;
}

// Strips of one colour, as black bars are, are looked up once; what lies between them is graded.
template <class T>
void grade_strips(const GradeTables& tables, const T* in, T* out, std::size_t pixels, float maximum,
                  bool streams) {
    std::size_t graded = 0;
    for (std::size_t i = 0; i + strip <= pixels; i += strip) {
        if (!is_of_one_color(in + 4 * i, strip)) {
            continue;
        }
        grade_vectors(tables, in + 4 * graded, out + 4 * graded, i - graded, maximum, streams);
        grade_vectors(tables, in + 4 * i, out + 4 * i, lanes, maximum, false);
        for (std::size_t k = lanes; k < strip; k += lanes) {
            std::copy_n(out + 4 * i, 4 * lanes, out + 4 * (i + k));
        }
        graded = i + strip;
    }
    grade_vectors(tables, in + 4 * graded, out + 4 * graded, pixels - graded, maximum, streams);
}

// Fewer pixels than a vector takes, in a copy.
template <class T>
void grade_few(const GradeTables& tables, const T* in, T* out, std::size_t pixels, float maximum) {
    std::array<T, 4 * lanes> copy{};
    std::copy(in, in + 4 * pixels, copy.begin());
    grade_vectors(tables, copy.data(), copy.data(), lanes, maximum, false);
    std::copy(copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(4 * pixels), out);
}

// What goes past the caches needs whole vectors from an aligned place.
template <class T>
void grade_row(const GradeTables& tables, const std::byte* from, std::byte* to, std::size_t pixels,
               int maximum, bool streams) {
    const auto* in = reinterpret_cast<const T*>(from);
    auto* out = reinterpret_cast<T*>(to);
    const float most = maximum > 0 ? static_cast<float>(maximum) : 1;
    if (streams) {
        constexpr std::size_t pixel = 4 * sizeof(T), line = 64;
        const std::size_t over = reinterpret_cast<std::uintptr_t>(out) % line;
        streams = over % pixel == 0;
        const std::size_t before = std::min(pixels, (line - over) % line / pixel);
        for (std::size_t done = 0; streams && done < before;) {
            const std::size_t count = std::min(lanes, before - done);
            grade_few(tables, in + 4 * done, out + 4 * done, count, most);
            done += count;
        }
        if (streams) {
            in += 4 * before;
            out += 4 * before;
            pixels -= before;
        }
    }
    const std::size_t whole = pixels / lanes * lanes;
    grade_strips(tables, in, out, whole, most, streams);
    if (whole < pixels) {
        grade_few(tables, in + 4 * whole, out + 4 * whole, pixels - whole, most);
    }
    if (streams) {
        hwy::FlushStream();
    }
}

void Grade(const GradeTables& tables, Element element, const std::byte* in, std::byte* out,
           std::size_t pixels, bool streams) {
    const int maximum = info_of(element).maximum;
    switch (element) {
    case Element::uint8:
        return grade_row<std::uint8_t>(tables, in, out, pixels, maximum, streams);
    case Element::uint10:
    case Element::uint16:
        return grade_row<std::uint16_t>(tables, in, out, pixels, maximum, streams);
    case Element::half:
        if constexpr (converts_halves) {
            return grade_row<hwy::float16_t>(tables, in, out, pixels, maximum, streams);
        }
        return;
    case Element::float32:
        return grade_row<float>(tables, in, out, pixels, maximum, streams);
    }
}

bool HasKernel(Element element) {
    return element != Element::half || converts_halves;
}
#endif

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lutlib {

HWY_EXPORT(Grade);
HWY_EXPORT(HasKernel);

bool has_kernel(Element element) {
    return HWY_DYNAMIC_DISPATCH(HasKernel)(element);
}

void grade_pixels(const GradeTables& tables, Element element, const std::byte* in, std::byte* out,
                  std::size_t pixels, bool past_caches) {
    HWY_DYNAMIC_DISPATCH(Grade)(tables, element, in, out, pixels, past_caches);
}

} // namespace lutlib
#endif
