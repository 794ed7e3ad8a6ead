#include "preview/effects/fusion.h"

#include <algorithm>

namespace preview {

std::string_view left_out_because(const EffectUse& use, const EffectSurroundings& frame) {
    if (strength_of(use) == 0) {
        return "its strength is 0";
    }
    if (use.effect->needs_depth && !frame.has_depth) {
        return "it needs the depth of a scene, and a picture has none";
    }
    switch (stage_of(use)) {
    case Stage::before_look:
        return frame.has_scene_look ? "a look takes light: no codes reach it" : "";
    case Stage::after_look:
    case Stage::last:
        return frame.compare == &compare_difference ? "a heat map shows no picture to lay it over"
                                                    : "";
    default:
        return frame.is_display_encoded ? "the picture is display-encoded already" : "";
    }
}

bool has_stage(const EffectUses& drawn, Stage stage) {
    return std::any_of(drawn.begin(), drawn.end(),
                       [&](const EffectUse& use) { return stage_of(use) == stage; });
}

Fusion fusion_of(const EffectUses& drawn, const Compare& compare) {
    return {.is_bloom_apart = has_stage(drawn, Stage::before_tonemap),
            .is_line_apart = compare.shows_one && (has_stage(drawn, Stage::after_look) ||
                                                   has_stage(drawn, Stage::last))};
}

} // namespace preview
