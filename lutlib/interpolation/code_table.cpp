#include "lutlib/interpolation/code_table.h"

#include "lutlib/interpolation/interpolation.h"
#include "lutlib/interpolation/sample.h"

#include <cstdint>
#include <cstring>

namespace lutlib {
namespace {

template <class In, class Out>
void look_up(const std::byte* table, const std::byte* in, std::ptrdiff_t in_step, std::byte* out,
             std::ptrdiff_t out_step, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i, in += in_step, out += out_step) {
        In code;
        std::memcpy(&code, in, sizeof code);
        std::memcpy(out, table + code * sizeof(Out), sizeof(Out));
    }
}

template <class In>
auto look_up_into(std::size_t out_bytes) {
    return out_bytes == 1   ? look_up<In, std::uint8_t>
           : out_bytes == 2 ? look_up<In, std::uint16_t>
                            : look_up<In, std::uint32_t>;
}

} // namespace

CodeTable::CodeTable(const Lut1D& curve, Element from, Element to) : out_bytes_(info_of(to).bytes) {
    const std::size_t bytes = info_of(from).bytes;
    const std::uint32_t codes = bytes == 1 ? 1 << 8 : 1 << 16;
    for (std::vector<std::byte>& channel : answers_) {
        channel.resize(codes * out_bytes_);
    }
    for (std::uint32_t code = 0; code < codes; ++code) {
        std::array<std::byte, 2> sample;
        const auto low = static_cast<std::uint8_t>(code);
        const auto both = static_cast<std::uint16_t>(code);
        std::memcpy(sample.data(), bytes == 1 ? static_cast<const void*>(&low) : &both, bytes);
        const double value = sample_value(from, sample.data());
        const RgbD answer = evaluate_exact(curve, RgbD{value, value, value});
        for (std::size_t c = 0; c < 3; ++c) {
            store_sample(to, answer[c], &answers_[c][code * out_bytes_]);
        }
    }
}

void CodeTable::apply(const ConstPictureView& in, const PictureView& out, std::size_t y,
                      std::size_t first, std::size_t end) const {
    const auto f = info_of(in.element).bytes == 1 ? look_up_into<std::uint8_t>(out_bytes_)
                                                  : look_up_into<std::uint16_t>(out_bytes_);
    for (std::size_t c = 0; c < 3; ++c) {
        f(answers_[c].data(), in.at(c, first, y), in.pixel_stride, out.at(c, first, y),
          out.pixel_stride, end - first);
    }
}

} // namespace lutlib
