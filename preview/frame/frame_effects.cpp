#include "preview/frame/frame_effects.h"

#include "preview/effects/fusion.h"
#include "preview/look/gpu_look.h"
#include "preview/scene/gpu_scene.h"
#include "preview/scene/nearest.h"

#include <algorithm>

namespace preview {

namespace {

bool has_scene_look(const FrameInputs& inputs, const FrameSettings& settings) {
    const auto is_before_tonemap = [](bool is_shown, const GpuLook* look) {
        return is_shown && look != nullptr && (look->place & PlaceBits::before) != 0;
    };
    return !settings.without.has(Effect::looks) &&
           (is_before_tonemap(settings.compare->shows_a, inputs.look_a) ||
            is_before_tonemap(settings.compare->shows_b, inputs.look_b));
}

/// What effects may be told of what the camera sees in a picture of `size`; of a picture nothing.
EffectDepth seen_depth(const FrameInputs& inputs, const FrameSettings& settings, Size size,
                       const FrameHandles& handles) {
    if (inputs.scene == nullptr) {
        return {};
    }
    const float aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    const Camera camera = camera_of(settings.orbit, aspect);
    EffectDepth out{handles.surfaces.depth, settings.orbit.near_plane, settings.orbit.near_plane,
                    -camera.projection[1][1]};
    const bool is_asked =
        std::any_of(settings.effects.begin(), settings.effects.end(),
                    [](const EffectUse& use) { return use.effect->idle_because != nullptr; });
    if (is_asked) {
        out.nearest = nearest_depth(*inputs.scene, inputs.gpu_scene->geometry,
                                    camera.projection * camera.view, settings.orbit.near_plane);
    }
    return out;
}

} // namespace

bool is_display_encoded(const FrameInputs& inputs) {
    return inputs.picture != nullptr && inputs.picture->display_encoded;
}

DrawnEffects drawn_effects(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings,
                           Size size, const FrameHandles& handles) {
    DrawnEffects drawn;
    drawn.given.seconds = settings.seconds;
    drawn.given.depth = seen_depth(inputs, settings, size, handles);
    const EffectDepth& depth = drawn.given.depth;
    const EffectSurroundings frame{settings.compare, is_display_encoded(inputs),
                                   has_scene_look(inputs, settings), static_cast<bool>(depth)};
    for (const EffectUse& use : settings.effects) {
        std::string_view reason = left_out_because(use, frame);
        if (reason.empty() && use.effect->idle_because != nullptr && !settings.force_all) {
            reason = use.effect->idle_because(use.values, depth, settings.output.height);
        }
        if (reason.empty()) {
            drawn.uses.push_back(use);
        } else {
            graph.withhold(use.effect->name, reason);
        }
    }
    for (const PostEffect* effect : post_effects()) {
        if (use_of(settings.effects, *effect) == nullptr) {
            graph.withhold(effect->name, "it is not in use");
        }
    }
    return drawn;
}

ImageHandle with_effects(Graph& graph, Stage stage, const DrawnEffects& drawn, ImageHandle picture,
                         FrameHandles& handles) {
    EffectInput in = drawn.given;
    for (const EffectUse& use : drawn.uses) {
        if (stage_of(use) == stage) {
            in.picture = picture;
            in.depth = use.effect->needs_depth ? drawn.given.depth : EffectDepth{};
            picture = use.effect->add(graph, in, use.values);
            handles.effects.push_back({use.effect, stage, picture});
        }
    }
    return picture;
}

std::string order_text(const FrameHandles& handles) {
    // What comes after the effects of each stage.
    constexpr std::string_view then[] = {"bloom", "tone map", "looks", "", "line and names"};
    std::string out = "order     light";
    for (const StageInfo& row : stages()) {
        for (const EffectPicture& made : handles.effects) {
            out += made.stage == row.stage ? ", " + std::string(made.effect->name) : "";
        }
        const std::string_view next = then[static_cast<std::size_t>(row.stage)];
        out += next.empty() ? "" : ", " + std::string(next);
    }
    return out + "\n";
}

} // namespace preview
