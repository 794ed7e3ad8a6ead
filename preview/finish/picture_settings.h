// What a person chooses of the picture: one struct for the command line, the window with its undo
// and the frame. Its initialisers are the defaults; the rows below are what flags, panels,
// --explain and --list are made from.
#pragma once

#include "preview/finish/blooms.h"
#include "preview/finish/compare.h"
#include "preview/finish/effect_use.h"
#include "preview/finish/effects.h"
#include "preview/finish/light_filters.h"
#include "preview/finish/picture_views.h"
#include "preview/finish/setting_rows.h"
#include "preview/finish/tonemaps.h"
#include "preview/finish/wipe.h"
#include "preview/finish/zoom.h"

#include <span>
#include <string>
#include <string_view>

namespace preview {

/// Ambient occlusion: how much of the surroundings nearby surfaces hide.
struct OcclusionSettings {
    float strength = 1;  ///< 0..2, times the scene's
    float radius = 0.3F; ///< metres: what lies farther away hides nothing
    float samples = 16;  ///< of a cell of pixels; a whole number in 1..64
    const OcclusionResolution* resolution = occlusion_resolution_named("half");
    friend bool operator==(const OcclusionSettings&, const OcclusionSettings&) = default;
};

struct PictureSettings : Wipe {
    float exposure = 0; ///< stops, added to the scene's
    const ShadowFilter* shadow_filter = shadow_filter_named("3x3");
    OcclusionSettings occlusion;
    const Tonemap* tonemap = tonemap_named("agx");
    const Bloom* bloom = bloom_named("glare");
    BloomSettings bloom_settings;
    const Compare* compare = &compare_a;
    float heat_scale = -1; ///< dE2000 at the heat map's end; negative: the 99th percentile
    const PictureView* picture_view = picture_view_named("picture");
    float zebra_level = 0.95F; ///< luma, 0..1, from which its stripes begin
    Zoom zoom;                 ///< which part of it is seen, and how large
    EffectSet without;         ///< parts of the frame that are switched off
    EffectUses effects;        ///< laid over it, in this order within each stage
    friend bool operator==(const PictureSettings&, const PictureSettings&) = default;
};

/// Its numbers, in the order of the frame.
std::span<const NumberRow<PictureSettings>> picture_numbers();
/// Its choices among rows of tables.
std::span<const ChoiceRow<PictureSettings>> picture_choices();

/// Rows by their flags, for what draws one of them at its own place. The flag must be there.
const NumberRow<PictureSettings>& picture_number(std::string_view flag);
const ChoiceRow<PictureSettings>& picture_choice(std::string_view flag);

/// A line for each number and choice: "setting   exposure 0 stops".
std::string settings_text(const PictureSettings& settings);

} // namespace preview
