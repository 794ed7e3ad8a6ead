#include "lutlib/interpolation/picture_view.h"

#include <algorithm>

namespace lutlib {
namespace {

constexpr std::array<ElementInfo, 5> element_rows{{
    {Element::uint8, "uint8", 1, 255},
    {Element::uint10, "uint10", 2, 1023},
    {Element::uint16, "uint16", 2, 65535},
    {Element::half, "half", 2, 0},
    {Element::float32, "float", 4, 0},
}};

template <class Byte>
BasicPictureView<Byte> packed(Byte* first, Element element, std::size_t channels, std::size_t width,
                              std::size_t height) {
    const std::size_t bytes = info_of(element).bytes;
    BasicPictureView<Byte> out;
    for (std::size_t c = 0; c < channels; ++c) {
        out.channel[c] = first + c * bytes;
    }
    out.element = element;
    out.width = width;
    out.height = height;
    out.pixel_stride = static_cast<std::ptrdiff_t>(channels * bytes);
    out.row_stride = out.pixel_stride * static_cast<std::ptrdiff_t>(width);
    return out;
}

} // namespace

std::span<const ElementInfo> elements() {
    return element_rows;
}

const ElementInfo& info_of(Element element) {
    return *std::find_if(element_rows.begin(), element_rows.end(),
                         [element](const ElementInfo& row) { return row.element == element; });
}

PictureView interleaved(void* first, Element element, std::size_t channels, std::size_t width,
                        std::size_t height) {
    return packed(static_cast<std::byte*>(first), element, channels, width, height);
}

ConstPictureView interleaved(const void* first, Element element, std::size_t channels,
                             std::size_t width, std::size_t height) {
    return packed(static_cast<const std::byte*>(first), element, channels, width, height);
}

} // namespace lutlib
