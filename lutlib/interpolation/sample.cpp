#include "lutlib/interpolation/sample.h"

#include "lutlib/codes.h"
#include "lutlib/half.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace lutlib {
namespace {

template <class T>
T read(const std::byte* at) {
    T out;
    std::memcpy(&out, at, sizeof out);
    return out;
}

template <class T>
void write(std::byte* at, T value) {
    std::memcpy(at, &value, sizeof value);
}

template <class Bits>
void copy_bits(const std::byte* in, std::ptrdiff_t in_step, std::byte* out, std::ptrdiff_t out_step,
               std::size_t count) {
    for (std::size_t i = 0; i < count; ++i, in += in_step, out += out_step) {
        write(out, read<Bits>(in));
    }
}

} // namespace

double sample_value(Element element, const std::byte* at) {
    switch (element) {
    case Element::uint8:
        return CodeDepth{8}.value(read<std::uint8_t>(at));
    case Element::uint10:
        return CodeDepth{10}.value(read<std::uint16_t>(at));
    case Element::uint16:
        return CodeDepth{16}.value(read<std::uint16_t>(at));
    case Element::half:
        return static_cast<double>(float_from_half(read<std::uint16_t>(at)));
    case Element::float32:
        break;
    }
    return static_cast<double>(read<float>(at));
}

void store_sample(Element element, double value, std::byte* at) {
    constexpr double largest = std::numeric_limits<float>::max();
    switch (element) {
    case Element::uint8:
        return write(at, static_cast<std::uint8_t>(CodeDepth{8}.code(value)));
    case Element::uint10:
        return write(at, CodeDepth{10}.code(value));
    case Element::uint16:
        return write(at, CodeDepth{16}.code(value));
    case Element::half:
        return write(at, half_from(value));
    case Element::float32:
        return write(at, std::isnan(value)
                             ? 0.0F
                             : static_cast<float>(std::clamp(value, -largest, largest)));
    }
}

void copy_samples(Element from, const std::byte* in, std::ptrdiff_t in_step, Element to,
                  std::byte* out, std::ptrdiff_t out_step, std::size_t count) {
    if (from == to) {
        switch (info_of(from).bytes) {
        case 1:
            return copy_bits<std::uint8_t>(in, in_step, out, out_step, count);
        case 2:
            return copy_bits<std::uint16_t>(in, in_step, out, out_step, count);
        default:
            return copy_bits<std::uint32_t>(in, in_step, out, out_step, count);
        }
    }
    for (std::size_t i = 0; i < count; ++i, in += in_step, out += out_step) {
        store_sample(to, sample_value(from, in), out);
    }
}

} // namespace lutlib
