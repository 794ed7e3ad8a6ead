#include "preview/look/look_texels.h"

#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "lutlib/half.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace preview {

namespace {

using Source = GpuLookup::Source;

constexpr int shared_size = 16;
constexpr std::uint32_t shaper_row = 4096;

template <class T>
void append(std::vector<std::byte>& bytes, T value) {
    std::array<std::byte, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
}

Texels float_volume(const lutlib::Lut3D& cube) {
    const auto n = static_cast<std::uint32_t>(cube.size);
    Texels out{{Format::rgba32f, n, n, n}, {}};
    for (const lutlib::Rgb& node : cube.nodes) {
        for (const float value : {node.r, node.g, node.b, 1.0F}) {
            append(out.bytes, value);
        }
    }
    return out;
}

Texels filtered_volume(const lutlib::Lut3D& cube) {
    const auto n = static_cast<std::uint32_t>(cube.size);
    const bool unit = std::all_of(cube.nodes.begin(), cube.nodes.end(), [](lutlib::Rgb node) {
        return std::min({node.r, node.g, node.b}) >= 0 && std::max({node.r, node.g, node.b}) <= 1;
    });
    Texels out{{unit ? Format::rgba16 : Format::rgba16f, n, n, n}, {}};
    for (const lutlib::Rgb& node : cube.nodes) {
        for (const float value : {node.r, node.g, node.b, 1.0F}) {
            append(out.bytes, unit ? lutlib::CodeDepth{16}.code(value) : lutlib::half_from(value));
        }
    }
    return out;
}

Texels shaper_texels(const lutlib::Lut1D& shaper) {
    const auto size = static_cast<std::uint32_t>(shaper.size());
    const std::uint32_t width = std::min(size, shaper_row);
    const std::uint32_t height = (size + width - 1) / width;
    Texels out{{Format::rgba32f, width, height}, {}};
    for (const lutlib::Rgb& entry : shaper.entries) {
        for (const float value : {entry.r, entry.g, entry.b, 1.0F}) {
            append(out.bytes, value);
        }
    }
    out.bytes.resize(out.desc.bytes());
    return out;
}

std::vector<std::uint16_t> half_nodes(const lutlib::CodeImage& strip, int size) {
    std::vector<std::uint16_t> nodes;
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                for (std::size_t c = 0; c < 4; ++c) {
                    nodes.push_back(c < 3 ? lutlib::half_from(strip.at({b * size + r, g}, c)) : 0);
                }
            }
        }
    }
    return nodes;
}

std::array<float, 4> padded(lutlib::Rgb c) {
    return {c.r, c.g, c.b, 0};
}

} // namespace

LookData no_look() {
    LookData data;
    data.lookup = gpu_lookup_named("none");
    return data;
}

LookData look_data(const lutlib::CodeImage& codes, int size, const GpuLookup& lookup) {
    const std::string name(lookup.name);
    if (lookup.source != Source::picture) {
        throw lutlib::Error("the lookup '" + name + "' reads tables, not pictures");
    }
    if (lookup.shared() && (size != shared_size || codes.depth.bits != 8)) {
        throw lutlib::Error("the lookup '" + name +
                            "' reads pictures of 16 nodes and 8 bits, not " + std::to_string(size) +
                            " nodes and " + std::to_string(codes.depth.bits) + " bits");
    }
    LookData data;
    data.lookup = &lookup;
    data.block.size = size;
    if (lookup.shared()) {
        data.nodes = half_nodes(codes, size);
    }
    const bool wide = codes.depth.bits > 8;
    data.picture.desc = {wide ? Format::rgba16 : Format::rgba8,
                         static_cast<std::uint32_t>(codes.width),
                         static_cast<std::uint32_t>(codes.height)};
    const int scale = wide ? 65535 / codes.depth.maximum() : 1;
    for (int y = 0; y < codes.height; ++y) {
        for (int x = 0; x < codes.width; ++x) {
            for (std::size_t c = 0; c < 4; ++c) {
                const int code = c < 3 ? codes.at({x, y}, c) : codes.depth.maximum();
                if (wide) {
                    append(data.picture.bytes, static_cast<std::uint16_t>(code * scale));
                } else {
                    append(data.picture.bytes, static_cast<std::uint8_t>(code));
                }
            }
        }
    }
    return data;
}

LookData look_data(const lutlib::Lut& look, const GpuLookup& lookup) {
    const std::string name(lookup.name);
    if (lookup.source != Source::table) {
        throw lutlib::Error("the lookup '" + name + "' reads pictures, not tables");
    }
    LookData data;
    data.lookup = &lookup;
    if (lookup.filtered &&
        (look.shaper || !look.cube || !look.cube->domain.is_unit() || look.cube->size > 256)) {
        throw lutlib::Error("the lookup '" + name +
                            "' reads only cubes over 0..1 without a shaper");
    }
    if (look.shaper) {
        data.shaper = shaper_texels(*look.shaper);
        data.block.shaper_min = padded(look.shaper->domain.min);
        data.block.shaper_max = padded(look.shaper->domain.max);
        data.block.shaper_size = look.shaper->size();
        data.block.shaper_row = static_cast<std::int32_t>(data.shaper.desc.width);
    }
    if (look.cube) {
        data.volume = lookup.filtered ? filtered_volume(*look.cube) : float_volume(*look.cube);
        data.block.cube_min = padded(look.cube->domain.min);
        data.block.cube_max = padded(look.cube->domain.max);
        data.block.size = look.cube->size;
    }
    return data;
}

} // namespace preview
