// One frame, from the scene to the finished picture: all its wiring is build_frame().
//
// What the scene or the settings do not need is left out: build_frame() withholds it and says why,
// and the graph drops every pass whose result nobody reads.
#pragma once

#include "lutlib/color/encoding.h"
#include "preview/finish/effects.h"
#include "preview/finish/probe.h"
#include "preview/finish/scopes.h"
#include "preview/frame/rasters.h"
#include "preview/passes/finish.h"
#include "preview/passes/lighting.h"
#include "preview/passes/resolve.h"
#include "preview/passes/view.h"
#include "preview/passes/visibility.h"
#include "preview/scene/gpu_scene.h"

#include <optional>
#include <span>
#include <string_view>

namespace preview {

struct DebugView;

struct FrameSettings {
    Size output{1280, 720};
    Orbit orbit;
    float exposure = 0;               ///< stops, applied in the HDR resolve
    const Tonemap* tonemap = nullptr; ///< null: the HDR values as they are
    const Bloom* bloom = nullptr;     ///< null: none
    BloomSettings bloom_settings;
    const Compare* compare = &compares[0];
    float split = 0.5F;
    float heat_scale = 8;
    EffectSet without; ///< what is switched off
    std::uint32_t shadow_size = 1024;
    Raster raster = Raster::hardware;
    VisibilityLimits visibility; ///< of Raster::compute
    /// Show this intermediate and nothing else.
    const DebugView* view = nullptr;
    /// Show this scope and nothing else, in its size of scope_sizes.
    const Scope* scope = nullptr;
    /// Of each row of scopes; {}: nobody looks at it.
    std::array<Size, scopes.size()> scope_sizes{};
    const ScopeSide* scope_side = &scope_side_shown;
    std::optional<bool> scope_logarithmic; ///< empty: each scope's own
    /// Tell the colour of this place of the output, before the looks and after each.
    std::optional<ProbePlace> probe;
    /// Count the colours before the looks along the curves' axes, their codes read in this
    /// encoding.
    const lutlib::Encoding* axes = nullptr;
    /// Present the HDR result before tone mapping too.
    bool keep_hdr = false;
    /// Leave out nothing that could be done: every skip that measures or looks at the scene is off.
    bool force_all = false;
};

/// What there is to render. Either a scene with its GPU part, or a picture.
struct FrameInputs {
    const Scene* scene = nullptr;
    const GpuScene* gpu_scene = nullptr;
    const std::vector<PointLight>* lights = nullptr; ///< null: the scene's own
    const GpuPicture* picture = nullptr;
    const GpuLook* look_a = nullptr; ///< null: no look
    const GpuLook* look_b = nullptr;
    /// The largest value of the HDR picture, measured in an earlier frame of the same scene, view
    /// and exposure; empty while it is not known.
    std::optional<float> hdr_maximum;
};

/// Every intermediate of the frame; empty where it is withheld.
struct FrameHandles {
    GBuffer surfaces;
    BufferHandle materials; ///< the scene's buffer
    ImageHandle shadow_maps, lit, hdr, bloom, graded;
    BufferHandle hdr_maximum, figures;
    std::array<ImageHandle, scopes.size()> scope_pictures; ///< of those looked at, presented
    BufferHandle probe, axis_counts;
    ImageHandle output; ///< rgba8, presented
};

/// An intermediate that can be shown, and how.
struct DebugView {
    std::string_view name;
    std::string_view help;
    ImageHandle (*handle)(const FrameHandles& handles);
    View view;
};
std::span<const DebugView> debug_views();
const DebugView* debug_view_named(std::string_view name);

/// Declares the frame. Presents the output, the HDR maximum, the figures of a difference and what
/// the settings keep; with a debug view the output alone. Throws lutlib::UsageError for a view of
/// something that this frame withholds.
FrameHandles build_frame(Graph& graph, const FrameInputs& inputs, const FrameSettings& settings);

} // namespace preview
