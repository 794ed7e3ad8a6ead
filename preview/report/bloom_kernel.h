// The kernels that bloom methods stand for, sampled at whole texels, and the exact convolution with
// them.
#pragma once

#include "preview/finish/blooms.h"
#include "preview/reference/image.h"

namespace preview::report {

/// strength * bloom(pre(light)) by a zero-padded float64 FFT, beyond the border the border's
/// texels. The kernel is that of the method: a sum of Gaussians where it is one; else the mean
/// response of its plan, linear and in double, to impulses at 16 places of its pyramid.
reference::Image exact_glow(const Bloom& bloom, const BloomSettings& settings,
                            const reference::Image& light);

/// light + strength * (bloom(pre(light)) - pre(light)) of such a glow.
reference::Image with_glow(const Bloom& bloom, const BloomSettings& settings,
                           const reference::Image& light, const reference::Image& glow);

} // namespace preview::report
