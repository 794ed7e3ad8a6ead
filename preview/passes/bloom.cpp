#include "preview/passes/bloom.h"

#include "preview/finish/bloom_dispatches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

namespace preview {

namespace {

using Block = std::array<std::array<float, 4>, BloomPlan::max_taps>;

/// What the dispatches of a plan are declared with.
struct Declared {
    Graph& graph;
    const BloomPlan& plan;
    ImageHandle hdr;
    std::vector<ImageHandle> images;
    std::uint32_t stored; ///< as shaders/common/stored.glsl calls the format

    ImageHandle image(int i) const {
        return i == BloomPlan::picture_image ? hdr : images[static_cast<std::size_t>(i)];
    }
    ImageHandle own(const BloomStep& step) const {
        return step.own < 0 ? ImageHandle{} : image(step.own);
    }
};

Block taps_block(const std::vector<BloomTap>& taps) {
    Block block{};
    for (std::size_t i = 0; i < taps.size(); ++i) {
        block[i] = {taps[i].x, taps[i].y, taps[i].weight, 0};
    }
    return block;
}

using Rows = std::array<std::array<float, 4>, 4>;

/// The weights of a step that halves_by_texels(), by row.
Rows rows_of_texels(const std::vector<BloomTap>& taps) {
    Rows rows{};
    for (const BloomTap& tap : taps) {
        rows[static_cast<std::size_t>(tap.y + 1.5F)][static_cast<std::size_t>(tap.x + 1.5F)] +=
            tap.weight;
    }
    return rows;
}

constexpr std::uint32_t stored_half = 0, stored_float = 1, stored_packed = 2;

/// How shaders/common/stored.glsl calls the format.
std::uint32_t stored_as(Format work) {
    return work == Format::rgba32f      ? stored_float
           : work == Format::r11g11b10f ? stored_packed
                                        : stored_half;
}

void add_halving(Declared& in, const BloomStep& step, const std::string& name,
                 ImageHandle& target) {
    Pass pass = in.graph.compute(name, "bloom_halve.comp");
    pass.sample(in.image(step.source), Sampler::linear_clamp);
    pass.uniform(in.graph.data_of(name + " weights", rows_of_texels(step.taps)));
    target = pass.write(target);
    pass.constants({step.prefilter, in.stored});
    pass.push(onset_of(in.plan));
    const Size size = size_of(in.graph, target);
    pass.dispatch_over(size.width, size.height);
}

void add_gaussian(Declared& in, const BloomStep& step, const std::string& name,
                  ImageHandle& target) {
    Pass pass = in.graph.compute(name, "bloom_gaussian.comp");
    pass.sample(in.image(step.source), Sampler::linear_clamp);
    pass.sample(in.own(step), Sampler::linear_clamp);
    pass.uniform(in.graph.data_of(name + " taps", taps_block(step.taps)));
    target = pass.write(target);
    pass.constants({static_cast<std::uint32_t>(step.taps.size()), step.axis == BloomStep::Axis::x,
                    step.own >= 0, in.stored});
    pass.push(std::array{step.keep, step.own_scale});
    const Size size = size_of(in.graph, target);
    pass.dispatch_over(size.width, size.height);
}

void add_filter(Declared& in, const BloomStep& step, const std::string& name, ImageHandle& target) {
    Pass pass = in.graph.compute(name, "bloom_filter.comp");
    pass.sample(in.image(step.source), Sampler::linear_clamp);
    pass.read(in.own(step));
    pass.uniform(in.graph.data_of(name + " taps", taps_block(step.taps)));
    target = pass.write(target);
    pass.constants({static_cast<std::uint32_t>(step.taps.size()), step.prefilter, step.karis,
                    step.own >= 0, in.stored});
    struct Push {
        float scale, keep;
        BloomOnset onset;
    };
    pass.push(Push{step.scale, step.keep, onset_of(in.plan)});
    const Size size = size_of(in.graph, target);
    pass.dispatch_over(size.width, size.height);
}

void add_step(Declared& in, const BloomStep& step, const std::string& name, ImageHandle& target) {
    const auto add = step.axis != BloomStep::Axis::both ? add_gaussian
                     // It keeps what it has fetched in halves.
                     : in.stored != stored_float && halves_by_texels(step) ? add_halving
                                                                           : add_filter;
    add(in, step, name, target);
}

/// Of bloom_quarter.comp.
struct QuarterWeights {
    Block taps;
    Rows rows;
};

void add_quarter(Declared& in, const BloomStep& one, const BloomStep& other,
                 const std::string& name, ImageHandle& target) {
    Pass pass = in.graph.compute(name, "bloom_quarter.comp");
    pass.sample(in.image(one.source), Sampler::linear_clamp);
    pass.uniform(in.graph.data_of(
        name + " weights",
        QuarterWeights{taps_block(one.taps), rows_of_texels(texel_taps(other.taps))}));
    target = pass.write(target);
    pass.constants({static_cast<std::uint32_t>(one.taps.size())});
    const BloomExtent& middle = in.plan.images[static_cast<std::size_t>(one.target)];
    pass.push(std::array{middle.width, middle.height});
    const Size size = size_of(in.graph, target);
    pass.dispatch_over(size.width, size.height);
}

/// Of bloom_blur.comp: what texel i of a thread's line weighs in result k.
struct BlurWeights {
    static constexpr std::size_t reach = 2 * BloomDispatch::most_reach;
    std::array<std::array<float, 8>, 8 + reach> along_x{};
    std::array<std::array<float, 4>, 2 + reach> along_y{};
};

/// Of two places on a line.
float weight_of(const std::vector<float>& weights, std::size_t a, std::size_t b) {
    const std::size_t apart = a > b ? a - b : b - a;
    return apart < weights.size() ? weights[apart] : 0;
}

void add_blur(Declared& in, const BloomStep& x, const BloomStep& y, const std::string& name,
              ImageHandle& target) {
    const std::vector<float> along_x = texel_weights(x.taps), along_y = texel_weights(y.taps);
    const std::size_t radius = std::max(along_x.size(), along_y.size()) - 1;
    BlurWeights block;
    for (std::size_t i = 0; i < block.along_x.size(); ++i) {
        for (std::size_t k = 0; k < block.along_x[i].size(); ++k) {
            block.along_x[i][k] = weight_of(along_x, i, k + radius);
        }
    }
    for (std::size_t i = 0; i < block.along_y.size(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            block.along_y[i][k] = weight_of(along_y, i, k + radius);
        }
    }
    Pass pass = in.graph.compute(name, "bloom_blur.comp");
    pass.sample(in.image(x.source), Sampler::linear_clamp);
    pass.sample(in.own(y), Sampler::linear_clamp);
    pass.storage(in.graph.data_of(name + " weights", block));
    target = pass.write(target);
    pass.constants({static_cast<std::uint32_t>(radius), y.own >= 0});
    pass.push(std::array{y.keep, y.own_scale});
    const Size size = size_of(in.graph, target);
    pass.dispatch_over(size.width, size.height, {32, 16});
}

/// Of bloom_small.comp.
struct SmallStep {
    std::array<std::int32_t, 4> source{}, own{}, target{}, rows{};
    std::array<float, 4> how{};
};
struct SmallBlock {
    std::array<SmallStep, BloomDispatch::most_steps> steps{};
    std::array<std::array<float, 4>, BloomDispatch::most_rows> rows{};
};
struct SmallPlan {
    SmallBlock block;
    std::size_t step_count = 0, row_count = 0;

    void add(const BloomStep& step, SmallStep made) {
        const std::size_t first = row_count;
        int radius = 0;
        if (step.axis == BloomStep::Axis::both) {
            for (std::size_t i = 0; i < step.taps.size(); ++i) {
                const BloomTap& tap = step.taps[i];
                block.rows[first + i] = {tap.x, tap.y, tap.weight, 0};
            }
        } else {
            const std::vector<float> weights = texel_weights(step.taps);
            const std::size_t reach = weights.size() - 1;
            for (std::size_t i = 0; i < rows_of(step); ++i) {
                for (std::size_t k = 0; k < 4; ++k) {
                    block.rows[first + i][k] = weight_of(weights, i, k + reach);
                }
            }
            radius = static_cast<int>(reach);
        }
        row_count += rows_of(step);
        made.rows = {static_cast<std::int32_t>(first), static_cast<std::int32_t>(row_count - first),
                     static_cast<std::int32_t>(step.axis), radius};
        made.how = {step.scale, step.own_scale, step.own < 0 ? 0 : step.keep, 0};
        block.steps[step_count++] = made;
    }
};

void add_small(Declared& in, const BloomDispatch& dispatch, const std::string& name,
               ImageHandle& target) {
    const std::span<const BloomStep> run =
        std::span(in.plan.steps).subspan(dispatch.first, dispatch.count);
    const auto placed = [&](int image) {
        std::int32_t place = -1;
        for (std::size_t i = 0; i < dispatch.places.size(); ++i) {
            place = run[i].target == image ? dispatch.places[i] : place;
        }
        const BloomExtent& extent = in.plan.images[static_cast<std::size_t>(image)];
        return std::array<std::int32_t, 4>{extent.width, extent.height, place, 0};
    };
    SmallPlan plan;
    for (const BloomStep& step : run) {
        plan.add(step, {.source = placed(step.source),
                        .own = placed(step.own < 0 ? step.source : step.own),
                        .target = placed(step.target)});
    }
    Pass pass = in.graph.compute(name, "bloom_small.comp");
    pass.sample(in.image(dispatch.source), Sampler::linear_clamp);
    pass.storage(in.graph.data_of(name + " plan", plan.block));
    target = pass.write(target);
    pass.push(static_cast<std::int32_t>(plan.step_count));
    pass.dispatch(1);
}

std::string name_of(const BloomPlan& plan, const BloomDispatch& dispatch) {
    const int first = plan.steps[dispatch.first].target;
    const int last = plan.steps[dispatch.first + dispatch.count - 1].target;
    return "bloom " + std::to_string(first) + (first == last ? "" : " to " + std::to_string(last));
}

} // namespace

BloomOnset onset_of(const BloomPlan& plan) {
    constexpr float none = 1e-30F; // its reciprocal is no longer finite soon below
    return {plan.threshold, plan.knee, plan.knee > none ? 0.25F / plan.knee : 0.0F};
}

Bloomed add_bloom(Graph& graph, ImageHandle hdr, const BloomPlan& plan, const BloomWork& work) {
    Declared in{graph, plan, hdr, std::vector<ImageHandle>(plan.images.size()),
                stored_as(work.format)};
    // What several steps share is kept in halves.
    const bool fuses = work.fuses && work.format == Format::rgba16f;
    for (const BloomDispatch& dispatch : bloom_dispatches(plan, fuses)) {
        const std::string name = name_of(plan, dispatch);
        const BloomStep& first = plan.steps[dispatch.first];
        const BloomStep& last = plan.steps[dispatch.first + dispatch.count - 1];
        const BloomExtent extent = plan.images[static_cast<std::size_t>(last.target)];
        ImageHandle& target = in.images[static_cast<std::size_t>(last.target)];
        target = image_kept_if(graph, work.is_kept && last.target == plan.last.image,
                               "bloom " + std::to_string(last.target),
                               {work.format, static_cast<std::uint32_t>(extent.width),
                                static_cast<std::uint32_t>(extent.height)},
                               "the light that blooms is the same");
        switch (dispatch.kind) {
        case BloomDispatch::Kind::step:
            add_step(in, first, name, target);
            break;
        case BloomDispatch::Kind::quarter:
            add_quarter(in, first, last, name, target);
            graph.withhold(name + " one by one", "one dispatch halves twice: nobody else reads it");
            break;
        case BloomDispatch::Kind::blur:
            add_blur(in, first, last, name, target);
            graph.withhold(name + " by axes",
                           "one dispatch does both: its texels fit into a group");
            break;
        case BloomDispatch::Kind::small:
            add_small(in, dispatch, name, target);
            graph.withhold(name + " one by one",
                           "one group does them all: their images fit into its memory");
            break;
        }
    }
    return {plan, plan.empty() ? ImageHandle{} : in.image(plan.last.image)};
}

} // namespace preview
