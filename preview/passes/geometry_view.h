// Shows a scene's triangles themselves, in place of the frame that is made of them.
#pragma once

#include "preview/passes/pass.h"
#include "preview/scene/scene_data.h"

#include <string_view>

namespace preview {

struct GeometryView {
    std::string_view fragment_shader;
    RasterState state;
    bool shows_material = false;
};

inline constexpr GeometryView geometry_wireframe{
    "geometry_white.frag", {.cull = RasterState::Cull::none, .draws_lines = true}};
inline constexpr GeometryView geometry_flat{"geometry_flat.frag", {}, true};
/// Adds 1 for each surface at a pixel, hidden ones too.
inline constexpr GeometryView geometry_overdraw{
    "geometry_white.frag", {.depth_test = false, .depth_write = false, .blends = true}};

/// rgba16f: light, or how many.
ImageHandle add_geometry_view(Graph& graph, const SceneHandles& scene, const GeometryView& view,
                              Size size, std::vector<Draw> draws);

} // namespace preview
