#include "preview/passes/bloom.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace preview {

namespace {

BufferHandle taps_block(Graph& graph, const std::string& name, const std::vector<BloomTap>& taps) {
    std::array<std::array<float, 4>, BloomPlan::max_taps> block{};
    for (std::size_t i = 0; i < taps.size(); ++i) {
        block[i] = {taps[i].x, taps[i].y, taps[i].weight, 0};
    }
    return graph.data_of(name + " taps", block);
}

/// The weights of a step that bloom_halve.comp can do, by row.
BufferHandle texel_weights(Graph& graph, const std::string& name,
                           const std::vector<BloomTap>& taps) {
    std::array<std::array<float, 4>, 4> rows{};
    for (const BloomTap& tap : taps) {
        rows[static_cast<std::size_t>(tap.y + 1.5F)][static_cast<std::size_t>(tap.x + 1.5F)] +=
            tap.weight;
    }
    return graph.data_of(name + " weights", rows);
}

/// How shaders/common/stored.glsl calls the format.
std::uint32_t stored_as(Format work) {
    return work == Format::rgba32f ? 1 : work == Format::r11g11b10f ? 2 : 0;
}

/// Whether bloom_halve.comp can do it: the taps are single texels of the four by four about the
/// target's.
bool halves_by_texels(const BloomStep& step) {
    const auto on_texel = [](float v) { return std::abs(v) == 0.5F || std::abs(v) == 1.5F; };
    return step.scale == 2 && !step.karis && step.own < 0 &&
           std::all_of(step.taps.begin(), step.taps.end(),
                       [&](const BloomTap& tap) { return on_texel(tap.x) && on_texel(tap.y); });
}

} // namespace

BloomLayers add_bloom(Graph& graph, ImageHandle hdr, const BloomPlan& plan, Format work,
                      bool are_kept) {
    BloomLayers out{plan, {}};
    const std::uint32_t stored = stored_as(work);
    std::vector<ImageHandle> images(plan.images.size());
    const auto image = [&](int i) {
        return i == BloomPlan::picture_image ? hdr : images[static_cast<std::size_t>(i)];
    };
    for (const BloomStep& step : plan.steps) {
        const BloomExtent extent = plan.images[static_cast<std::size_t>(step.target)];
        const auto width = static_cast<std::uint32_t>(extent.width);
        const auto height = static_cast<std::uint32_t>(extent.height);
        const auto count = static_cast<std::uint32_t>(step.taps.size());
        const std::string name = "bloom " + std::to_string(step.target);
        const bool separable = step.axis != BloomStep::Axis::both;
        const bool is_layer =
            std::any_of(plan.layers.begin(), plan.layers.end(),
                        [&](const BloomPlan::Layer& layer) { return layer.image == step.target; });
        const ImageHandle target =
            image_kept_if(graph, are_kept && is_layer, name, {work, width, height},
                          "the light that blooms is the same");

        // It keeps what it has fetched in halves.
        const bool by_texels = !separable && work != Format::rgba32f && halves_by_texels(step);

        Pass pass = graph.compute(name, separable   ? "bloom_gaussian.comp"
                                        : by_texels ? "bloom_halve.comp"
                                                    : "bloom_filter.comp");
        pass.sample(image(step.source), Sampler::linear_clamp);
        if (!separable && !by_texels) {
            pass.read(step.own < 0 ? ImageHandle{} : image(step.own));
        }
        pass.uniform(by_texels ? texel_weights(graph, name, step.taps)
                               : taps_block(graph, name, step.taps));
        images[static_cast<std::size_t>(step.target)] = pass.write(target);
        if (separable) {
            pass.constants({count, step.axis == BloomStep::Axis::x, stored});
        } else if (by_texels) {
            pass.constants({step.prefilter, stored});
            pass.push(std::array{plan.threshold, plan.knee});
        } else {
            pass.constants({count, step.prefilter, step.karis, step.own >= 0, stored});
            pass.push(std::array{step.scale, step.keep, plan.threshold, plan.knee});
        }
        pass.dispatch_over(width, height);
    }
    for (std::size_t i = 0; i < plan.layers.size(); ++i) {
        out.images[i] = image(plan.layers[i].image);
    }
    return out;
}

} // namespace preview
