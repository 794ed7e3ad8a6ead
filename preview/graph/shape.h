// What of a graph two frames are compared by, as bytes.
#pragma once

#include "preview/graph/byte_text.h"
#include "preview/graph/graph.h"

namespace preview {

/// What a resource is, not what it holds.
inline void add_resource(ByteText& text, const Resource& resource) {
    text.add(resource.kind);
    text.add(resource.image.format);
    text.add(resource.image.width);
    text.add(resource.image.height);
    text.add(resource.image.depth);
    text.add(resource.image.layers);
    text.add(resource.bytes);
    text.add(resource.serial);
}

/// How a pass is bound to what it reads or writes, without which that is.
inline void add_binding(ByteText& text, const Use& use) {
    text.add(use.access);
    text.add(use.binding);
    text.add(use.sampler);
    text.add(use.neutral);
    text.add(use.layer);
    text.add(use.writes);
    text.add(use.only_if_read);
}

inline void add_raster_state(ByteText& text, const RasterState& state) {
    text.add(state.cull);
    text.add(state.depth_test);
    text.add(state.depth_write);
    text.add(state.depth_bias_constant);
    text.add(state.depth_bias_slope);
    text.add(state.draws_lines);
    text.add(state.blends);
}

} // namespace preview
