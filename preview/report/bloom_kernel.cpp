#include "preview/report/bloom_kernel.h"

#include "preview/reference/bloom.h"
#include "preview/reference/convolution.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace preview::report {

namespace {

using lutlib::RgbD;
using reference::Image;

/// Of `kernel`, by the distance from its middle; 0 outside.
struct SampledKernel {
    Image values;
    int reach = 0;

    double operator()(double dx, double dy) const {
        return values.at(reach + static_cast<int>(dx), reach + static_cast<int>(dy)).g;
    }
};

/// Level by level a pyramid sees an impulse otherwise; 4x4 places, spread over its largest texel,
/// stand for all of them. A picture twice as large at half the radius has the same pyramid.
SampledKernel response(const Bloom& bloom, const BloomSettings& settings, int width, int height) {
    constexpr int places = 4;
    BloomSettings linear{1, 0, 0, settings.radius / 2};
    BloomPlan plan = bloom_plan(bloom, {2 * width, 2 * height}, linear);
    int coarsest = 1;
    for (BloomStep& step : plan.steps) {
        step.karis = false;
        const int across = plan.images[static_cast<std::size_t>(step.target)].width;
        coarsest = std::max(coarsest, (2 * width + across - 1) / across);
    }
    SampledKernel out;
    out.reach = std::min(width, height) - coarsest;
    const int side = 2 * out.reach + 1;
    out.values = Image(side, side);
    const double share = 1.0 / (places * places);
    for (int place = 0; place < places * places; ++place) {
        const int x = width + place % places * coarsest / places,
                  y = height + place / places * coarsest / places;
        Image impulse(2 * width, 2 * height);
        impulse.at(x, y) = {1, 1, 1};
        const Image seen = reference::bloom(plan, impulse);
        for (int dy = -out.reach; dy <= out.reach; ++dy) {
            for (int dx = -out.reach; dx <= out.reach; ++dx) {
                const bool is_inside =
                    x + dx >= 0 && y + dy >= 0 && x + dx < seen.width && y + dy < seen.height;
                RgbD& sum = out.values.at(out.reach + dx, out.reach + dy);
                sum = sum + (is_inside ? seen.at(x + dx, y + dy) : RgbD{}) * share;
            }
        }
    }
    return out;
}

/// Out to where less than 1e-5 of the widest Gaussian's light is missing.
int reach_of(std::span<const BloomGaussian> gaussians, double scale) {
    double widest = 0;
    for (const BloomGaussian& one : gaussians) {
        widest = std::max(widest, static_cast<double>(one.sigma) * scale);
    }
    return std::max(static_cast<int>(std::ceil(4.8 * widest)), 2);
}

} // namespace

Image exact_glow(const Bloom& bloom, const BloomSettings& settings, const Image& light) {
    const BloomPlan plan = bloom_plan(bloom, {light.width, light.height}, settings);
    if (plan.empty()) {
        return {light.width, light.height};
    }
    Image bright = light;
    for (RgbD& pixel : bright.pixels) {
        pixel = reference::prefiltered(plan, pixel);
    }
    Image glow;
    if (bloom.gaussians.empty()) {
        const SampledKernel kernel = response(bloom, settings, light.width, light.height);
        glow = reference::convolved(bright, kernel.reach, std::cref(kernel));
    } else {
        const double scale =
            static_cast<double>(settings.radius) * light.height / bloom_nominal_height;
        glow = reference::convolved(
            bright, reach_of(bloom.gaussians, scale), [&](double dx, double dy) {
                double sum = 0;
                for (const BloomGaussian& one : bloom.gaussians) {
                    sum += static_cast<double>(one.weight) *
                           reference::gaussian(dx, dy, static_cast<double>(one.sigma) * scale);
                }
                return sum;
            });
    }
    for (RgbD& pixel : glow.pixels) {
        pixel = pixel * static_cast<double>(plan.strength);
    }
    return glow;
}

Image with_glow(const Bloom& bloom, const BloomSettings& settings, const Image& light,
                const Image& glow) {
    const BloomPlan plan = bloom_plan(bloom, {light.width, light.height}, settings);
    Image out = light;
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        const RgbD moved = plan.empty() ? RgbD{}
                                        : reference::prefiltered(plan, light.pixels[i]) *
                                              static_cast<double>(plan.strength);
        out.pixels[i] = light.pixels[i] + glow.pixels[i] - moved;
    }
    return out;
}

} // namespace preview::report
