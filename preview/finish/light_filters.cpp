#include "preview/finish/light_filters.h"

#include "lutlib/named.h"

namespace preview {

namespace {

constexpr ShadowFilter filters[] = {
    {"1x1", "a texel wide, smooth between texels: one gather, a GPU's own filter", 1, 1},
    {"3x3", "three by three texels: four gathers", 3, 1},
    {"5x5", "five by five texels: nine gathers", 5, 1},
    {"disc", "eight places of a Poisson disc five texels wide: eight gathers", 1, 8},
};

constexpr OcclusionResolution resolutions[] = {
    {"full", "every pixel by itself", 1},
    {"half", "two by two pixels share one", 2},
    {"quarter", "four by four pixels share one", 4},
};

} // namespace

std::span<const ShadowFilter> shadow_filters() {
    return filters;
}

const ShadowFilter* shadow_filter_named(std::string_view name) {
    return lutlib::find_named(shadow_filters(), name);
}

std::span<const OcclusionResolution> occlusion_resolutions() {
    return resolutions;
}

const OcclusionResolution* occlusion_resolution_named(std::string_view name) {
    return lutlib::find_named(occlusion_resolutions(), name);
}

} // namespace preview
