// What a frame is asked for, what there is to render, and what it has made. Plain: no Vulkan
// header.
#pragma once

#include "lutlib/color/encoding.h"
#include "preview/finish/picture_settings.h"
#include "preview/finish/probe.h"
#include "preview/finish/scopes.h"
#include "preview/frame/rasters.h"
#include "preview/passes/bloom.h"
#include "preview/passes/gbuffer.h"
#include "preview/passes/scope.h"
#include "preview/passes/still.h"
#include "preview/passes/surroundings.h"
#include "preview/passes/visibility.h"
#include "preview/scene/scene.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace preview {

struct DebugView;
enum class Stage : std::uint8_t; // preview/effects/effect.h
struct GpuLook;
struct GpuPicture;
struct GpuScene;

/// What a person chooses, and what the program adds.
struct FrameSettings : PictureSettings {
    Size output{1280, 720};
    Orbit orbit;
    double seconds = 0;            ///< the moment that animated effects show
    std::uint32_t shadow_size = 0; ///< texels of a shadow map's side; 0: the scene's
    Raster raster = Raster::hardware;
    VisibilityLimits visibility; ///< of Raster::compute
    /// How finely passes work; `lutpreview report` says what that costs and takes.
    Format bloom_format = Format::rgba16f; ///< of its pyramid
    Size surroundings_base = surroundings_base_size;
    /// Show this intermediate and nothing else.
    const DebugView* view = nullptr;
    /// Show what this effect has made and nothing else.
    const PostEffect* effect_view = nullptr;
    /// Show this scope and nothing else, in its size of scope_sizes.
    const Scope* scope = nullptr;
    /// Of each row of scopes; {}: nobody looks at it.
    std::array<Size, scopes.size()> scope_sizes{};
    const ScopeSide* scope_side = &scope_side_shown;
    ScopeRegion scope_region;
    std::optional<bool> scope_logarithmic; ///< empty: each scope's own
    /// Count all scopes, seen or not, and present what they count.
    bool keeps_scopes = false;
    const ScopeGain* scope_gain = &scope_gain_none;
    ScopeLevels scope_levels; ///< of the scopes that have levels
    /// Of figures that the window writes over the scopes; empty: they have their own.
    std::optional<FigureSize> scope_figures;
    /// Tell the colour of this place of the output, before the looks and after each.
    std::optional<ProbePlace> probe;
    /// Count the colours before the looks along the curves' axes, their codes read in this
    /// encoding.
    const lutlib::Encoding* axes = nullptr;
    /// Of the finished picture and of intermediates: rgba8, or rgba32f for files of more bits.
    Format format = Format::rgba8;
    /// Spread the rounding to 8 bits over neighbouring texels.
    bool dithers = false;
    /// An intermediate's own numbers in place of colours that stand for them.
    bool shows_numbers = false;
    /// Present the HDR result before tone mapping too.
    bool keep_hdr = false;
    /// Present the HDR maximum, light that is kept or asked for, and nothing else.
    bool only_maximum = false;
    /// Keep the light that the looks get, and what blooms of it, for the executor's next frame: of
    /// the same scene, camera and exposure that one only finishes it. The price is memory that is
    /// then shared with nothing.
    bool keeps_light = false;
    /// Run every pass, even those that this scene does not need: every skip that measures or looks
    /// at the scene is off, and nothing is kept from an earlier frame.
    bool force_all = false;
    /// But for shadow maps and those of the surroundings, which are none of what is measured: these
    /// stay while neither lights nor casters move.
    bool forced_keeps_maps = false;

    bool reuses_light() const { return keeps_light && !force_all; }
    bool reuses_maps() const { return !force_all || forced_keeps_maps; }
    bool shows_intermediate() const { return view != nullptr || effect_view != nullptr; }
};

/// What a scope has counted in an earlier frame.
struct KeptScope {
    const gpu::Buffer* counts = nullptr;              ///< null: nothing is kept
    std::uint32_t columns = 0, width = 0, height = 0; ///< as ScopeCounts has them
};

/// What there is to render. Either a scene with its GPU part, or a picture.
struct FrameInputs {
    const Scene* scene = nullptr;
    const GpuScene* gpu_scene = nullptr;
    const std::vector<PointLight>* lights = nullptr;  ///< null: the scene's own
    const Surroundings* surroundings = nullptr;       ///< null: the scene's own
    const GpuPicture* surroundings_picture = nullptr; ///< null: there is none
    const GpuPicture* picture = nullptr;
    const GpuLook* look_a = nullptr; ///< null: no look
    const GpuLook* look_b = nullptr;
    std::array<std::string_view, 2> no_look{"there is none",
                                            "there is none"}; ///< why a side has none
    /// Shown on a side as it is, in place of the picture under that side's look; null: no still.
    std::array<const GpuPicture*, 2> stills{};
    /// Of each row of scopes: drawn in place of what it would count now.
    std::array<KeptScope, scopes.size()> kept_scopes{};
    /// What a comparison calls its sides; both empty: it names none.
    std::array<std::string_view, 2> names{};
    /// The largest value of the HDR picture, measured in an earlier frame of the same scene, view
    /// and exposure; empty while it is not known.
    std::optional<float> hdr_maximum;
};

/// What an effect has made.
struct EffectPicture {
    const PostEffect* effect = nullptr;
    Stage stage{}; ///< in which it stands
    ImageHandle picture;
};

/// Every intermediate of the frame; empty where it is withheld.
struct FrameHandles {
    GBuffer surfaces;
    BufferHandle materials; ///< the scene's buffer
    ImageHandle shadow_maps, occlusion, lit, light_counts, hdr, bloom, graded, geometry;
    Bloomed bloomed;                   ///< `bloom` is its glow
    BufferHandle hdr_maximum, figures; ///< a picture that no resolve changes has no maximum
    std::array<ImageHandle, scopes.size()> scope_pictures; ///< of those looked at, presented
    std::array<ScopeCounts, scopes.size()> scope_counts;   ///< presented if the settings keep them
    BufferHandle probe, axis_counts;
    std::vector<EffectPicture> effects; ///< of those drawn, in the order of the frame
    std::array<StillSide, 2> stills;    ///< as large as the picture; of sides that show a still
    /// What views of the picture read: it before it is rounded, and before the looks.
    ImageHandle unrounded, before_looks;
    ImageHandle output; ///< presented
};

} // namespace preview
