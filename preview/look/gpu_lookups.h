// The ways of reading a look on the GPU, as a table: the general ones, then one for each engine of
// lutlib. Rows name their functions in shaders/common/lookup.glsl; the build writes the choice
// among them from this table (preview/shader_tables), so that a function that is missing fails it.
#pragma once

#include "lutlib/engine/engine.h"
#include "lutlib/interpolation/interpolation.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace preview {

struct GpuLookup {
    /// What it reads: nothing, an engine's picture of codes, or a look's own float table.
    enum class Source : std::uint8_t { none, picture, table };

    std::string_view name;
    std::string_view label;
    Source source = Source::none;
    /// Its GLSL function; empty for a picture whose layout, place and interpolation say all.
    std::string_view shader = {};
    /// The GLSL function that reads 16 nodes of 8 bits from shared memory; empty: it has none.
    std::string_view shared_shader = {};
    /// The layout of its pictures; empty for Source::table.
    std::string_view layout = {};
    /// The engine whose arithmetic it is, or null.
    const lutlib::Engine* engine = nullptr;
    lutlib::Interpolation interpolation = lutlib::Interpolation::trilinear;
    /// The texture unit filters, with 8 bits of fraction on most GPUs.
    bool filtered = false;

    /// From shared memory: pictures of 16 nodes and 8 bits only.
    bool shared() const { return !shared_shader.empty(); }
};

std::span<const GpuLookup> gpu_lookups();
const GpuLookup* gpu_lookup_named(std::string_view name);
/// The row's place in the table, by which shaders know it.
int index_of(const GpuLookup& row);

} // namespace preview
