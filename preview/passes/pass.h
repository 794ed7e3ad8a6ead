// How a pass is written.
//
// One pass is a pair passes/NAME.h/.cpp and a shader shaders/NAME.comp (shaders/NAME.vert and
// .frag where geometry is rasterised). Its header declares one function of the form
//
//     ImageHandle add_NAME(Graph& graph, ImageHandle input, ..., const NameSettings& settings);
//
// which declares the pass on the graph and returns what it writes. A pass knows neither Vulkan nor
// who made its inputs: those are handles, and an empty handle is an input that the frame withholds
// (the shader sees the neutral stand-in, or a specialisation constant tells it not to look).
// passes/copy.cpp with shaders/copy.comp is the smallest example; graph/graph.h has the conventions
// for bindings, push constants and specialisation constants; frame.cpp joins the passes.
//
// Rules that keep a frame fast and its numbers right:
// - Full-screen work is compute; only geometry is rasterised.
// - Work images are Format::rgba16f, displayed ones Format::rgba8 unless the settings name another.
//   Pyramids are one transient image a level; the graph shares memory between what does not meet.
// - No pass keeps state between frames. What changes each frame goes through push constants or
//   graph.data(); what does not is imported. What an earlier frame has made may be kept whole
//   (image_kept_if()), as the graph knows whether it would be made again alike.
// - Values are finite after the HDR resolve; before it a pass may meet anything.
// - The order of texels is rows from the top; texel centres are at half-integers.
#pragma once

#include "preview/gpu/size.h"
#include "preview/graph/graph.h"

#include <array>

namespace preview {

inline Size size_of(const Graph& graph, ImageHandle image) {
    const ImageDesc& desc = graph.image_desc(image);
    return {desc.width, desc.height};
}

/// An image that the executor keeps for its next frame while `is_kept`. `still_right` as of
/// Graph::persistent_image().
inline ImageHandle image_kept_if(Graph& graph, bool is_kept, std::string_view name,
                                 const ImageDesc& desc, std::string_view still_right) {
    return is_kept ? graph.persistent_image(name, desc, still_right) : graph.image(name, desc);
}

inline BufferHandle buffer_kept_if(Graph& graph, bool is_kept, std::string_view name,
                                   std::uint64_t bytes, std::string_view still_right) {
    return is_kept ? graph.persistent_buffer(name, bytes, still_right) : graph.buffer(name, bytes);
}

/// Groups of a pass whose groups count in shared memory and add their sums to a buffer: a group's
/// clearing and adding is little beside its share of the picture, and there are no more groups than
/// the largest GPUs hold.
constexpr std::uint32_t counting_groups(std::uint64_t texels) {
    constexpr std::uint64_t share = 8192, most = 528;
    const std::uint64_t groups = (texels + share - 1) / share;
    return static_cast<std::uint32_t>(groups < 1 ? 1 : groups > most ? most : groups);
}
} // namespace preview
