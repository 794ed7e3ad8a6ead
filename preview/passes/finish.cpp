#include "preview/passes/finish.h"

#include "preview/look/gpu_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace preview {

namespace {

constexpr std::uint64_t figures_bytes = sizeof(std::uint32_t) * (1 + DifferenceBins::count);

// Of finish_shared.comp.
constexpr std::uint32_t tile_width = 32, tile_height = 128;

struct FilterBlock {
    std::array<float, 4> scale{};
    std::array<std::array<float, 4>, BloomPlan::max_final_taps> taps{};
};

FilterBlock filter_block(const BloomPlan& plan) {
    FilterBlock block;
    const std::vector<BloomTap>& taps = plan.last.taps;
    block.scale[0] = plan.last.scale;
    for (std::size_t i = 0; i < taps.size(); ++i) {
        block.taps[i] = {taps[i].x, taps[i].y, taps[i].weight, 0};
    }
    return block;
}

struct Push {
    WipeShape wipe;
    float exposure, strength, heat_scale;
    BloomOnset onset;
};

ImageHandle imported(Graph& graph, const std::string& name,
                     const std::optional<gpu::Image>& image) {
    return image ? graph.import(name, *image, image->desc()) : ImageHandle{};
}

void bind_look(Graph& graph, Pass& pass, const std::string& side, const GpuLook* look) {
    const std::string name = "look " + side;
    const std::optional<gpu::Image> nothing;
    pass.sample(imported(graph, name + " picture", look ? look->picture : nothing),
                Sampler::linear_clamp);
    pass.sample(imported(graph, name + " volume", look ? look->volume : nothing),
                Sampler::linear_clamp, Neutral::black_3d);
    pass.read(imported(graph, name + " shaper", look ? look->shaper : nothing));
    pass.uniform(look ? graph.data_of(name, look->block) : graph.data_of("no look", LookBlock{}));
}

/// The table of a tone map that is a curve.
BufferHandle curve_of(Graph& graph, const Tonemap* tonemap) {
    if (tonemap == nullptr || tonemap->curve == nullptr) {
        return {};
    }
    return graph.data("tone curve", std::as_bytes(tabulated_curve(*tonemap)));
}

/// The rows of common/look_conversion.glsl for the sides with looks around which something is
/// converted.
BufferHandle conversions_of(Graph& graph, const GpuLook* a, const GpuLook* b) {
    std::vector<std::array<float, 4>> rows;
    std::string name = "conversions for look";
    const auto add = [&](const GpuLook* look, const char* side, std::size_t first) {
        if (look != nullptr && !look->conversions.empty()) {
            rows.resize(first);
            rows.insert(rows.end(), look->conversions.begin(), look->conversions.end());
            name += side;
        }
    };
    add(a, " A", 0);
    add(b, " B", conversion_row_count);
    return rows.empty() ? BufferHandle{} : graph.data(name, std::as_bytes(std::span(rows)));
}

std::uint32_t place_of(const GpuLook* look) {
    return look != nullptr ? look->place : 0;
}

std::uint32_t shader_of(const GpuLook* look) {
    return look ? static_cast<std::uint32_t>(index_of(*look->lookup)) : 0;
}

bool is_shared(const GpuLook* look) {
    return look && look->lookup->shared();
}

} // namespace

void bind_finish(Graph& graph, Pass& pass, const Finishing& finishing,
                 std::span<const std::uint32_t> own_constants) {
    const auto& [picture, bloom, a, b, settings] = finishing;
    const BloomPlan& plan = bloom.plan;
    pass.read(picture);
    pass.sample(bloom.glow, Sampler::linear_clamp);
    // A frame may have both: one pass that composites the bloom, and one that finds it done.
    pass.uniform(
        graph.data_of(plan.empty() ? "no bloom filter" : "bloom final filter", filter_block(plan)));
    bind_look(graph, pass, "A", a);
    bind_look(graph, pass, "B", b);
    pass.storage(curve_of(graph, settings.tonemap));
    pass.storage(conversions_of(graph, a, b));

    const Format format = graph.image_desc(picture).format;
    const bool unit =
        format == Format::rgba8 || format == Format::rgb10a2 || format == Format::rgba16;
    const int tonemap = settings.tonemap ? index_of(*settings.tonemap) : -1;
    std::vector<std::uint32_t> constants{static_cast<std::uint32_t>(tonemap),
                                         static_cast<std::uint32_t>(plan.last.taps.size()),
                                         plan.threshold > 0,
                                         shader_of(a),
                                         shader_of(b),
                                         static_cast<std::uint32_t>(index_of(*settings.compare)),
                                         unit,
                                         settings.has_marks,
                                         place_of(a),
                                         place_of(b)};
    constants.insert(constants.end(), own_constants.begin(), own_constants.end());
    pass.constants(std::move(constants));
    pass.push(Push{wipe_shape(settings, *settings.compare, size_of(graph, picture)),
                   std::exp2(settings.exposure), plan.strength, settings.heat_scale,
                   onset_of(plan)});
}

Finished add_finish(Graph& graph, const Finishing& finishing) {
    Finishing shown = finishing;
    const FinishSettings& settings = shown.settings;
    const Compare& compare = *settings.compare;
    const GpuLook* const a = compare.shows_a ? shown.look_a : nullptr;
    const GpuLook* const b = compare.shows_b ? shown.look_b : nullptr;
    shown.look_a = a;
    shown.look_b = b;
    const Size size = size_of(graph, shown.picture);
    const bool side = &compare == &compare_side;
    const bool difference = &compare == &compare_difference;
    const GpuLook* const shared = is_shared(a) ? a : is_shared(b) ? b : nullptr;
    const bool half = shared && shared->half_arithmetic && settings.format == Format::rgba8;

    Finished out;
    BufferHandle figures = graph.buffer("figures", difference ? figures_bytes : 8);
    if (difference) {
        figures = graph.fill("clear figures", figures, 0);
    }
    const ImageHandle target =
        graph.image("finished", {settings.format, side ? 2 * size.width : size.width, size.height});

    Pass pass = graph.compute(settings.name, half     ? "finish_shared_half.comp"
                                             : shared ? "finish_shared.comp"
                                                      : "finish.comp");
    bind_finish(graph, pass, shown, std::array<std::uint32_t, 1>{settings.format == Format::rgba8});
    out.picture = pass.write(target);
    figures = difference ? pass.modify(figures) : pass.write(figures);
    if (difference) {
        out.figures = figures;
    }
    if (shared) {
        pass.storage(graph.import("look nodes", *shared->nodes, shared->nodes->bytes()));
    }

    if (shared) {
        const std::uint32_t tiles = ((size.width + tile_width - 1) / tile_width) *
                                    ((size.height + tile_height - 1) / tile_height);
        pass.dispatch(std::min(tiles, shared->groups));
    } else {
        pass.dispatch_over(size.width, size.height, many_each);
    }
    return out;
}

} // namespace preview
