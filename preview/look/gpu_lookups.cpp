#include "preview/look/gpu_lookups.h"

#include "lutlib/named.h"

#include <vector>

namespace preview {

namespace {

using lutlib::Interpolation;
using Source = GpuLookup::Source;

std::vector<GpuLookup> make_table() {
    std::vector<GpuLookup> table{
        {.name = "none", .label = "no look"},
        {.name = "strip",
         .label = "2D strip, eight texel fetches, trilinear",
         .source = Source::picture,
         .layout = "strip"},
        {.name = "strip-bilinear",
         .label = "2D strip, two fetches filtered by the texture unit",
         .source = Source::picture,
         .shader = "strip_bilinear",
         .layout = "strip",
         .filtered = true},
        {.name = "volume",
         .label = "3D texture filtered by the texture unit",
         .source = Source::table,
         .shader = "volume_filtered",
         .filtered = true},
        {.name = "nearest",
         .label = "float table with shaper and domain, nearest node",
         .source = Source::table,
         .shader = "table_nearest",
         .interpolation = Interpolation::nearest},
        {.name = "trilinear",
         .label = "float table with shaper and domain, eight nodes",
         .source = Source::table,
         .shader = "table_trilinear"},
        {.name = "tetrahedral",
         .label = "float table with shaper and domain, four nodes",
         .source = Source::table,
         .shader = "table_tetrahedral",
         .interpolation = Interpolation::tetrahedral},
        {.name = "shared-trilinear",
         .label = "16 nodes in shared memory, eight nodes",
         .source = Source::picture,
         .shared_shader = "trilinear16",
         .layout = "strip"},
        {.name = "shared-tetrahedral",
         .label = "16 nodes in shared memory, four nodes",
         .source = Source::picture,
         .shared_shader = "tetrahedral16",
         .layout = "strip",
         .interpolation = Interpolation::tetrahedral},
    };
    for (const lutlib::Engine& engine : lutlib::engines()) {
        table.push_back({.name = engine.name,
                         .label = engine.label,
                         .source = Source::picture,
                         .shader = engine.shader,
                         .layout = engine.layout,
                         .engine = &engine,
                         .interpolation = engine.interpolation});
    }
    return table;
}

} // namespace

std::span<const GpuLookup> gpu_lookups() {
    static const std::vector<GpuLookup> table = make_table();
    return table;
}

const GpuLookup* gpu_lookup_named(std::string_view name) {
    return lutlib::find_named(gpu_lookups(), name);
}

int index_of(const GpuLookup& row) {
    return static_cast<int>(&row - gpu_lookups().data());
}

} // namespace preview
