#include "lutlib/interpolation/grade.h"
#include "lutlib/interpolation/sample.h"

namespace lutlib {

void grade_plainly(const Lut& lut, Interpolation how, const ConstPictureView& in,
                   const PictureView& out) {
    for (std::size_t y = 0; y < in.height; ++y) {
        for (std::size_t x = 0; x < in.width; ++x) {
            const bool is_identity = !lut.shaper && !lut.cube;
            for (std::size_t c = is_identity ? 0 : 3; c < 4; ++c) {
                if (in.channel[c] && out.channel[c]) {
                    copy_samples(in.element, in.at(c, x, y), 0, out.element, out.at(c, x, y), 0, 1);
                }
            }
            if (is_identity) {
                continue;
            }
            RgbD color;
            for (std::size_t c = 0; c < 3; ++c) {
                color[c] = sample_value(in.element, in.at(c, x, y));
            }
            const RgbD graded = evaluate_exact(lut, color, how);
            for (std::size_t c = 0; c < 3; ++c) {
                store_sample(out.element, graded[c], out.at(c, x, y));
            }
        }
    }
}

} // namespace lutlib
