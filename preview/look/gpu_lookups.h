// The ways of reading a look on the GPU, as a table: the general ones, then one for each engine of
// lutlib. Rows and shader numbers meet in shaders/common/lookup.glsl.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/engine/engine.h"
#include "lutlib/interpolation/interpolation.h"
#include "preview/gpu/types.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace preview {

struct Lookup {
    /// What it reads: nothing, an engine's picture of codes, or a look's own float table.
    enum class Source : std::uint8_t { none, picture, table };

    std::string_view name;
    std::string_view label;
    Source source = Source::none;
    int shader = 0;
    /// The layout of its pictures; empty for Source::table.
    std::string_view layout = {};
    /// The engine whose arithmetic it is, or null.
    const lutlib::Engine* engine = nullptr;
    /// What it computes otherwise.
    lutlib::Interpolation interpolation = lutlib::Interpolation::trilinear;
    /// The texture unit filters, with 8 bits of fraction on most GPUs.
    bool filtered = false;
    /// From shared memory: pictures of 16 nodes and 8 bits only.
    bool shared = false;
};

std::span<const Lookup> lookups();
const Lookup* lookup_named(std::string_view name);

/// The uniform block `Look` of the shader.
struct LookBlock {
    std::array<float, 4> shaper_min{}, shaper_max{1, 1, 1, 1};
    std::array<float, 4> cube_min{}, cube_max{1, 1, 1, 1};
    std::int32_t size = 0, shaper_size = 0, shaper_row = 1, unused = 0;
};

/// Texels of an image to make.
struct Texels {
    ImageDesc desc;
    std::vector<std::byte> bytes; ///< empty: no such image
};

/// What a lookup reads, ready for the GPU.
struct LookData {
    const Lookup* lookup = nullptr;
    LookBlock block;
    Texels picture, volume, shaper;
    /// Of Lookup::shared: three half floats and a gap a node, red fastest.
    std::vector<std::uint16_t> nodes;
};

/// No look.
LookData no_look();

/// An engine's picture, for rows of Source::picture. Throws lutlib::Error where the row reads no
/// such picture (the shared ones: 16 nodes, 8 bits).
LookData look_data(const lutlib::CodeImage& codes, int size, const Lookup& lookup);

/// A look's own table in float, for rows of Source::table. The texture unit's row keeps 16 bits of
/// values within 0..1, half floats of others; it knows neither shaper nor domain and throws
/// lutlib::Error for a look that has them.
LookData look_data(const lutlib::Lut& look, const Lookup& lookup);

} // namespace preview
