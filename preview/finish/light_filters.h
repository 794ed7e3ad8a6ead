// How finely light is worked out, as tables of choices: what shadow maps are filtered by, and how
// many pixels share an ambient occlusion.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace preview {

/// By how many texels of a shadow map about a point its shadow is averaged. A gather reads two by
/// two of them, as a GPU's own comparison filter does.
struct ShadowFilter {
    std::string_view name;
    std::string_view help;
    std::uint32_t side;   ///< of the square, in texels; between texels it is smooth
    std::uint32_t places; ///< squares, spread over a disc; 1: the square lies about the point
};

std::span<const ShadowFilter> shadow_filters();
/// The row of that name, which must be there.
const ShadowFilter* shadow_filter_named(std::string_view name);

/// One value is made for a cell of side by side pixels, and pixels between take those that lie in
/// their plane.
struct OcclusionResolution {
    std::string_view name;
    std::string_view help;
    std::uint32_t side;
};

std::span<const OcclusionResolution> occlusion_resolutions();
const OcclusionResolution* occlusion_resolution_named(std::string_view name);

} // namespace preview
