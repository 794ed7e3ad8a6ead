#include "preview/effects/fusion.h"

#include <algorithm>

namespace preview {

std::string_view left_out_because(const EffectUse& use, const Compare& compare,
                                  bool is_display_encoded) {
    if (strength_of(use) == 0) {
        return "its strength is 0";
    }
    if (use.effect->stage == Stage::after_look) {
        return &compare == &compare_difference ? "a heat map shows no picture to lay it over" : "";
    }
    return is_display_encoded ? "the picture is display-encoded already" : "";
}

bool has_stage(const EffectUses& drawn, Stage stage) {
    return std::any_of(drawn.begin(), drawn.end(),
                       [&](const EffectUse& use) { return use.effect->stage == stage; });
}

Fusion fusion_of(const EffectUses& drawn, const Compare& compare) {
    return {.is_bloom_apart = has_stage(drawn, Stage::before_tonemap),
            .is_line_apart = &compare == &compare_split && has_stage(drawn, Stage::after_look)};
}

} // namespace preview
