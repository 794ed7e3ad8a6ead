#include "lutlib/transform.h"

#include "lutlib/interpolation/interpolation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace lutlib {
namespace {

// Colours that stages pass to each other through the first-level cache.
constexpr std::size_t block = 512;

} // namespace

Transform Transform::of(std::shared_ptr<const Lut> lut, std::optional<Interpolation> how) {
    const Interpolation by = how.value_or(usual_interpolation(*lut));
    return each([lut = std::move(lut), by](RgbD c) { return evaluate_exact(*lut, c, by); });
}

Transform Transform::of(const Lut& lut, std::optional<Interpolation> how) {
    return of(std::shared_ptr<const Lut>(std::shared_ptr<const Lut>(), &lut), how);
}

Transform in_sequence(std::vector<Transform> steps) {
    const bool coarse = std::any_of(steps.begin(), steps.end(), [](const Transform& step) {
        return step.precision() == Precision::float32;
    });
    return Transform::batch(
        [steps = std::move(steps)](std::span<RgbD> colors) {
            for (const Transform& step : steps) {
                step(colors);
            }
        },
        coarse ? Precision::float32 : Precision::float64);
}

void apply_in_parallel(const Transform& transform, std::span<RgbD> colors) {
    const auto apply = [&](std::size_t begin, std::size_t end) {
        for (std::size_t at = begin; at < end; at += block) {
            transform(colors.subspan(at, std::min(block, end - at)));
        }
    };
    // Threads take longer to start than the nodes of a usual strip to compute.
    constexpr std::size_t few = 4096;
    if (colors.size() <= few) {
        apply(0, colors.size());
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, colors.size(), 4 * block),
                      [&](const auto& range) { apply(range.begin(), range.end()); });
}

std::vector<RgbD> images_of(const Transform& transform, std::span<const Rgb> inputs) {
    std::vector<RgbD> out(inputs.size());
    std::transform(inputs.begin(), inputs.end(), out.begin(), to_double);
    apply_in_parallel(transform, out);
    return out;
}

} // namespace lutlib
