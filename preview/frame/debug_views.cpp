#include "lutlib/named.h"
#include "preview/frame/frame.h"

namespace preview {

namespace {

constexpr DebugView views[] = {
    {.name = "depth",
     .help = "distance from the camera, near is bright",
     .handle = [](const FrameHandles& h) { return h.surfaces.depth; },
     .view = {.shader = "view_depth.comp"}},
    {.name = "normal",
     .help = "world-space normals as n / 2 + 1/2",
     .handle = [](const FrameHandles& h) { return h.surfaces.normal; },
     .view = {.shader = "view_normal.comp"}},
    {.name = "albedo",
     .help = "surface colour",
     .handle = [](const FrameHandles& h) { return h.surfaces.material; },
     .view = {.shader = "view_albedo.comp", .shows_material = true}},
    {.name = "roughness",
     .help = "perceptual roughness",
     .handle = [](const FrameHandles& h) { return h.surfaces.material; },
     .view = {.shader = "view_roughness.comp", .shows_material = true}},
    {.name = "metalness",
     .help = "metalness",
     .handle = [](const FrameHandles& h) { return h.surfaces.material; },
     .view = {.shader = "view_metalness.comp", .shows_material = true}},
    {.name = "emission",
     .help = "light that surfaces emit",
     .handle = [](const FrameHandles& h) { return h.surfaces.material; },
     .view = {.shader = "view_emission.comp", .shows_material = true}},
    {.name = "wireframe",
     .help = "the edges of all triangles",
     .handle = [](const FrameHandles& h) { return h.geometry; },
     .view = {.shader = "view_light.comp"},
     .geometry = &geometry_wireframe},
    {.name = "flat",
     .help = "facets in their materials' colours, lit from the eye",
     .handle = [](const FrameHandles& h) { return h.geometry; },
     .view = {.shader = "view_light.comp"},
     .geometry = &geometry_flat},
    {.name = "overdraw",
     .help = "how many surfaces lie at a pixel, hidden ones too",
     .handle = [](const FrameHandles& h) { return h.geometry; },
     .view = {.shader = "view_overdraw.comp"},
     .geometry = &geometry_overdraw},
    {.name = "shadows",
     .help = "the shadow maps side by side, near is bright",
     .handle = [](const FrameHandles& h) { return h.shadow_maps; },
     .view = {.shader = "view_shadow.comp"}},
    {.name = "occlusion",
     .help = "what nearby surfaces leave of the light of the surroundings",
     .handle = [](const FrameHandles& h) { return h.occlusion; },
     .view = {.shader = "view_occlusion.comp"}},
    {.name = "lights",
     .help = "how many lights each pixel evaluates; none of the sky and of unlit surfaces",
     .handle = [](const FrameHandles& h) { return h.light_counts; },
     .view = {.shader = "view_lights.comp"},
     .counts_lights = true},
    {.name = "lit",
     .help = "radiance before the HDR resolve",
     .handle = [](const FrameHandles& h) { return h.lit; },
     .view = {.shader = "view_light.comp"}},
    {.name = "hdr",
     .help = "exposed light after the HDR resolve",
     .handle = [](const FrameHandles& h) { return h.hdr; },
     .view = {.shader = "view_light.comp"}},
    {.name = "bloom",
     .help = "the last level of the bloom, before its composite",
     .handle = [](const FrameHandles& h) { return h.bloom; },
     .view = {.shader = "view_light.comp"}},
    {.name = "graded",
     .help = "the finished picture before antialiasing",
     .handle = [](const FrameHandles& h) { return h.graded; },
     .view = {.shader = "view_codes.comp"}},
};

} // namespace

std::span<const DebugView> debug_views() {
    return views;
}

const DebugView* debug_view_named(std::string_view name) {
    return lutlib::find_named(views, name);
}

} // namespace preview
