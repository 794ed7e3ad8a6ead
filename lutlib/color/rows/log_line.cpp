#include "lutlib/color/rows/log_line.h"

namespace lutlib {

void log_line_decode_all(const LogLine& p, std::span<RgbD> colors) {
    const double code_cut = p.code_of(p.cut);
    each_piece(colors, [&](std::span<double> x, std::span<double> t) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            t[i] = (x[i] - p.d) / p.c;
        }
        exp_all(t);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = x[i] < code_cut ? std::min((x[i] - p.f) / p.e, p.cut)
                                   : std::clamp((t[i] - p.b) / p.a, p.cut, largest_light);
        }
    });
}

void log_line_encode_all(const LogLine& p, std::span<RgbD> colors) {
    const double code_cut = p.code_of(p.cut);
    each_piece(colors, [&](std::span<double> x, std::span<double> t) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            t[i] = p.a * std::clamp(x[i], p.cut, largest_light) + p.b;
        }
        log_all(t);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = x[i] < p.cut ? std::min(p.e * x[i] + p.f, code_cut)
                                : std::max(p.c * t[i] + p.d, code_cut);
        }
    });
}

} // namespace lutlib
