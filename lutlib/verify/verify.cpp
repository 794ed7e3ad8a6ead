#include "lutlib/verify/verify.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

TexelCheck check_texels(const CodeImage& picture, const Engine& engine, int size,
                        const Transform& look) {
    const auto [pixels, values] = right_texels(picture, engine, size, look);
    TexelCheck out;
    out.texels = values.size();
    const int maximum = picture.depth.maximum();
    const double tolerance = tolerance_of(look.precision());
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        bool wrong = false;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = saturate(values[i][c]);
            const int code = picture.at(pixels[i], c);
            if (is_rounded(code, value, maximum, tolerance)) {
                continue;
            }
            wrong = true;
            const int difference = std::abs(code - picture.depth.code(value));
            sum += difference;
            if (difference > out.max_difference) {
                out.max_difference = difference;
                out.worst = pixels[i];
            }
        }
        out.wrong += wrong;
    }
    out.mean_difference = sum / (3.0 * static_cast<double>(values.size()));
    return out;
}

} // namespace

Verification verify(const CodeImage& picture, const Engine& engine, int size, const Transform& look,
                    const Breaks& breaks, const Viewing& viewing, const SampleLimits& limits,
                    const Alternatives& alternatives) {
    Verification out;
    out.texels = check_texels(picture, engine, size, look);
    out.lookup = measure_lookup(picture, engine, size, look, breaks, viewing, limits);
    if (out.texels.wrong > 0) {
        Findings found = diagnose(picture, engine, size, look, breaks, alternatives);
        out.diagnosis = std::move(found.diagnosis);
        out.nearest = std::move(found.nearest);
    }
    return out;
}

} // namespace lutlib
