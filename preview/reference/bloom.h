// The bloom passes in double: what a plan must give, step by step.
#pragma once

#include "preview/finish/blooms.h"
#include "preview/reference/image.h"

namespace preview::reference {

/// The light of a colour that blooms.
lutlib::RgbD prefiltered(const BloomPlan& plan, lutlib::RgbD light);

/// bloom(pre(hdr)) by the plan's steps.
Image bloom(const BloomPlan& plan, const Image& hdr);

/// hdr + strength * (bloom(pre(hdr)) - pre(hdr)).
Image with_bloom(const BloomPlan& plan, const Image& hdr);

} // namespace preview::reference
