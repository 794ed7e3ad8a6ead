// Pictures where they lie in memory: interleaved or planar, of any element and any stride.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>

namespace lutlib {

/// How a sample is stored, in the processor's own order of bytes.
enum class Element { uint8, uint10, uint16, half, float32 };

struct ElementInfo {
    Element element;
    std::string_view name;
    std::size_t bytes; ///< of a sample; 10 bits lie in the low bits of 16
    int maximum;       ///< the code that stands for 1; 0: floating point
};
/// 8 bits, 10 in 16, 16 bits, half, float.
std::span<const ElementInfo> elements();
const ElementInfo& info_of(Element element);

/// A picture that somebody else owns. `Byte` is std::byte, or const std::byte where it is only
/// read. Samples are aligned to their size.
template <class Byte>
struct BasicPictureView {
    /// The first pixel's red, green, blue and alpha; alpha is null where there is none.
    std::array<Byte*, 4> channel{};
    Element element = Element::float32;
    std::size_t width = 0, height = 0;
    /// Bytes from a sample to the next pixel's and to the next row's; may be negative.
    std::ptrdiff_t pixel_stride = 0, row_stride = 0;

    bool has_alpha() const { return channel[3] != nullptr; }
    Byte* at(std::size_t c, std::size_t x, std::size_t y) const {
        return channel[c] + static_cast<std::ptrdiff_t>(x) * pixel_stride +
               static_cast<std::ptrdiff_t>(y) * row_stride;
    }
    friend bool operator==(const BasicPictureView&, const BasicPictureView&) = default;
    operator BasicPictureView<const std::byte>() const requires(!std::is_const_v<Byte>) {
        return {{channel[0], channel[1], channel[2], channel[3]},
                element,
                width,
                height,
                pixel_stride,
                row_stride};
    }
};
using PictureView = BasicPictureView<std::byte>;
using ConstPictureView = BasicPictureView<const std::byte>;

/// Pixels of `channels` samples, 3 or 4, one after the other without gaps.
PictureView interleaved(void* first, Element element, std::size_t channels, std::size_t width,
                        std::size_t height);
ConstPictureView interleaved(const void* first, Element element, std::size_t channels,
                             std::size_t width, std::size_t height);

} // namespace lutlib
