#include "preview/report/bloom_kernel.h"

#include "preview/reference/bloom.h"
#include "preview/reference/convolution.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string_view>
#include <utility>

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

/// Texels of the picture that one of a plan's coarsest image spans.
int coarsest_texel(const BloomPlan& plan, int width) {
    int out = 1;
    for (const BloomExtent& image : plan.images) {
        out = std::max(out, (width + image.width - 1) / image.width);
    }
    return out;
}

/// Level by level a pyramid sees an impulse otherwise; 4x4 places, spread over its largest texel,
/// stand for all of them. What a method does to an impulse depends on how often it halves alone, so
/// that a picture serves that is so many times as large as that texel.
SampledKernel response(const Bloom& bloom, float radius, int height, int texel) {
    constexpr int places = 4, texels_across = 16, least = 64, most = 1024;
    const int side = std::clamp(texels_across * texel, least, most);
    const BloomSettings linear{1, 0, 0,
                               radius * static_cast<float>(height) / static_cast<float>(side)};
    BloomPlan plan = bloom_plan(bloom, {side, side}, linear);
    for (BloomStep& step : plan.steps) {
        step.karis = false;
    }
    std::array<Image, std::size_t{places} * places> seen;
    const auto shift = [&](int place) { return place * texel / places; };
    tbb::parallel_for(0, places * places, [&](int place) {
        Image impulse(side, side);
        impulse.at(side / 2 + shift(place % places), side / 2 + shift(place / places)) = {1, 1, 1};
        seen[static_cast<std::size_t>(place)] = reference::bloom(plan, impulse);
    });
    SampledKernel out;
    out.reach = side / 2 - texel;
    out.values = Image(2 * out.reach + 1, 2 * out.reach + 1);
    const double share = 1.0 / (places * places);
    for (int place = 0; place < places * places; ++place) {
        const int x = side / 2 + shift(place % places), y = side / 2 + shift(place / places);
        for (int dy = -out.reach; dy <= out.reach; ++dy) {
            for (int dx = -out.reach; dx <= out.reach; ++dx) {
                RgbD& sum = out.values.at(out.reach + dx, out.reach + dy);
                sum = sum + seen[static_cast<std::size_t>(place)].at(x + dx, y + dy) * share;
            }
        }
    }
    return out;
}

/// Each is made once: many inputs have the same.
const SampledKernel& kernel_of(const Bloom& bloom, const BloomSettings& settings, int width,
                               int height) {
    static std::map<std::pair<std::string_view, int>, SampledKernel> made;
    const int texel = coarsest_texel(bloom_plan(bloom, {width, height}, settings), width);
    const auto [place, is_new] = made.try_emplace({bloom.name, texel});
    if (is_new) {
        place->second = response(bloom, settings.radius, height, texel);
    }
    return place->second;
}

/// Out to where 0.2 % of the widest Gaussian's light is missing, which is the faintest of them.
int reach_of(std::span<const BloomGaussian> gaussians, double scale) {
    double widest = 0;
    for (const BloomGaussian& one : gaussians) {
        widest = std::max(widest, static_cast<double>(one.sigma) * scale);
    }
    return std::max(static_cast<int>(std::ceil(3.5 * widest)), 2);
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
        const SampledKernel& kernel = kernel_of(bloom, settings, light.width, light.height);
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
