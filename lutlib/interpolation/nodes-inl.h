// The values of one pixel or node, side by side in a vector, and how they are loaded from what a
// StoredLut keeps.
// Compiled once for each instruction set, as apply.cpp is.
#if defined(LUTLIB_INTERPOLATION_NODES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LUTLIB_INTERPOLATION_NODES_INL_H
#undef LUTLIB_INTERPOLATION_NODES_INL_H
#else
#define LUTLIB_INTERPOLATION_NODES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace lutlib::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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
inline Pixel unpacked_10_bits(std::uint32_t word) {
    return pixel_of([word](std::size_t c) {
        return static_cast<float>(static_cast<int>(word >> (10 * c) & 1023));
    });
}
inline Pixel operator+(Pixel a, Pixel b) {
    return pixel_of([&](std::size_t c) { return a.channel[c] + b.channel[c]; });
}
inline Pixel operator*(Pixel a, float s) {
    return pixel_of([&](std::size_t c) { return a.channel[c] * s; });
}
inline void store(Pixel a, float* p) {
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

// How a node's values are loaded: 16 bytes at most from its first. `bytes`: to the next node.
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
    static constexpr std::size_t bytes = 16;
    static constexpr float scale = 1;
    static HWY_INLINE Pixel at(const std::uint8_t* p) {
        return loaded(reinterpret_cast<const float*>(p));
    }
};

} // namespace lutlib::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
