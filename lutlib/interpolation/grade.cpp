#include "lutlib/interpolation/grade.h"

#include "lutlib/interpolation/code_table.h"
#include "lutlib/interpolation/grade_tables.h"
#include "lutlib/interpolation/sample.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace lutlib {
namespace {

// Pixels of four samples of any element that are copied to be graded, a kernel's strip of them.
constexpr std::size_t copied = 256;

bool is_packed(const ConstPictureView& view, std::size_t channels) {
    const std::size_t bytes = info_of(view.element).bytes;
    bool out = view.pixel_stride == static_cast<std::ptrdiff_t>(channels * bytes);
    for (std::size_t c = 1; c < channels; ++c) {
        out = out && view.channel[c] == view.channel[0] + c * bytes;
    }
    return out && (channels == 4 || !view.has_alpha());
}

// Packed RGB to packed RGBA and back, a pixel's four samples at once: the fourth is the next
// pixel's first, or is written over by it.
template <std::size_t from_step, std::size_t to_step, std::size_t bytes>
void repack_pixels(const std::byte* from, std::byte* to, std::size_t count) {
    for (std::size_t i = 0; i + 1 < count; ++i) {
        std::memcpy(to + i * to_step * bytes, from + i * from_step * bytes, 4 * bytes);
    }
    std::memcpy(to + (count - 1) * to_step * bytes, from + (count - 1) * from_step * bytes,
                3 * bytes);
}
template <std::size_t from_step, std::size_t to_step>
void repack(const std::byte* from, std::byte* to, std::size_t count, std::size_t bytes) {
    bytes == 1   ? repack_pixels<from_step, to_step, 1>(from, to, count)
    : bytes == 2 ? repack_pixels<from_step, to_step, 2>(from, to, count)
                 : repack_pixels<from_step, to_step, 4>(from, to, count);
}

bool is_same_memory(const ConstPictureView& a, const ConstPictureView& b) {
    return a == b;
}

// Rows that follow one another without a gap are one long row.
template <class Byte>
BasicPictureView<Byte> as_one_row(BasicPictureView<Byte> view) {
    view.width *= view.height;
    view.height = 1;
    return view;
}

bool is_without_gaps(const ConstPictureView& view) {
    return view.row_stride == view.pixel_stride * static_cast<std::ptrdiff_t>(view.width);
}

/// One picture's way through the kernels.
class Work {
  public:
    Work(const GradeTables& tables, const ConstPictureView& in, const PictureView& out)
        : tables_(tables), in_(in), out_(out),
          element_(in.element == out.element && has_kernel(in.element) ? in.element
                                                                       : Element::float32) {
        // A picture of more bytes than caches keep is written past them, unless it is graded in
        // place: its lines are in the caches then.
        constexpr std::size_t least_bytes = std::size_t{1} << 22;
        const std::size_t bytes = 4 * info_of(out.element).bytes * out.width * out.height;
        past_caches_ = !is_same_memory(in, out) && bytes >= least_bytes;
        const bool is_alike = in.element == element_ && out.element == element_;
        direct_ = is_alike && is_packed(in, 4) && is_packed(out, 4);
        repacks_ = is_alike && is_packed(in, 3) && is_packed(out, 3);
        if (tables.size == 0 && tables.shaper && info_of(in.element).bytes < sizeof(float)) {
            codes_.emplace(*tables.shaper, in.element, out.element);
        }
        if (is_without_gaps(in) && is_without_gaps(out)) {
            in_ = as_one_row(in);
            out_ = as_one_row(out);
        }
    }

    std::size_t width() const { return in_.width; }
    std::size_t height() const { return in_.height; }

    void operator()(std::size_t y, std::size_t first, std::size_t end) const {
        if (tables_.size == 0 && !tables_.shaper) {
            copy_channels(y, first, end, 0);
            return;
        }
        if (codes_) {
            codes_->apply(in_, out_, y, first, end);
            copy_channels(y, first, end, 3);
            return;
        }
        if (direct_) {
            grade_pixels(tables_, element_, in_.at(0, first, y), out_.at(0, first, y), end - first,
                         past_caches_);
            return;
        }
        alignas(64) std::array<std::byte, copied * 4 * sizeof(float)> copy;
        for (std::size_t x = first; x < end; x += copied) {
            const std::size_t count = std::min(copied, end - x);
            fetch(x, y, count, copy.data());
            grade_pixels(tables_, element_, copy.data(), copy.data(), count, false);
            put(x, y, count, copy.data());
        }
    }

  private:
    // Alpha goes its own way; the copy's holds nothing.
    void fetch(std::size_t x, std::size_t y, std::size_t count, std::byte* copy) const {
        const std::size_t bytes = info_of(element_).bytes;
        if (repacks_) {
            return repack<3, 4>(in_.at(0, x, y), copy, count, bytes);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            copy_samples(in_.element, in_.at(c, x, y), in_.pixel_stride, element_, copy + c * bytes,
                         static_cast<std::ptrdiff_t>(4 * bytes), count);
        }
    }
    void put(std::size_t x, std::size_t y, std::size_t count, const std::byte* copy) const {
        const std::size_t bytes = info_of(element_).bytes;
        if (repacks_) {
            return repack<4, 3>(copy, out_.at(0, x, y), count, bytes);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            copy_samples(element_, copy + c * bytes, static_cast<std::ptrdiff_t>(4 * bytes),
                         out_.element, out_.at(c, x, y), out_.pixel_stride, count);
        }
        copy_channels(y, x, x + count, 3);
    }
    // The channels from `first_channel` on that both have.
    void copy_channels(std::size_t y, std::size_t first, std::size_t end,
                       std::size_t first_channel) const {
        for (std::size_t c = first_channel; c < 4; ++c) {
            if (in_.channel[c] && out_.channel[c]) {
                copy_samples(in_.element, in_.at(c, first, y), in_.pixel_stride, out_.element,
                             out_.at(c, first, y), out_.pixel_stride, end - first);
            }
        }
    }

    const GradeTables& tables_;
    ConstPictureView in_;
    PictureView out_;
    Element element_;
    std::optional<CodeTable> codes_;
    bool direct_ = false, repacks_ = false, past_caches_ = false;
};

} // namespace

Grading::Grading(const Lut& lut, Interpolation how)
    : tables_(std::make_shared<const GradeTables>(lut, how)) {}

void grade(const Grading& look, const ConstPictureView& in, const PictureView& out, int threads) {
    if (in.width != out.width || in.height != out.height) {
        throw std::invalid_argument("grade: the pictures differ in size");
    }
    const Work work(look.tables(), in, out);
    const auto all = [&] {
        // Enough to be worth the taking, few enough to share out.
        constexpr std::size_t grain = 16384;
        const std::size_t parts = (work.width() + grain - 1) / grain;
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, parts * work.height(),
                                            std::max<std::size_t>(1, grain / (work.width() + 1))),
            [&](const auto& range) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) {
                    const std::size_t first = i % parts * grain;
                    work(i / parts, first, std::min(work.width(), first + grain));
                }
            });
    };
    if (threads == 1) {
        for (std::size_t y = 0; y < work.height(); ++y) {
            work(y, 0, work.width());
        }
    } else if (threads > 1) {
        tbb::task_arena(threads).execute(all);
    } else {
        all();
    }
}

} // namespace lutlib
