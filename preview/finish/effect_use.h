// A post effect in use, as a setting of the picture; preview/effects/effect.h has the effects.
#pragma once

#include "lutlib/ops/op.h"

#include <vector>

namespace preview {

struct PostEffect;

struct EffectUse {
    const PostEffect* effect = nullptr;
    lutlib::Values values;    ///< of its parameters
    bool before_look = false; ///< in place of after the looks, where its effect stands there
    friend bool operator==(const EffectUse&, const EffectUse&) = default;
};

/// Each effect at most once.
using EffectUses = std::vector<EffectUse>;

} // namespace preview
