// What passes say of images, descriptors and raster state, by our own names, so that neither they
// nor the graph need a Vulkan header.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace preview {

enum class Format : std::uint8_t {
    rgba8,
    rgb10a2,
    rg16ui,
    rgba16,
    rgba16f,
    r32f,
    r32ui,
    rgba32f,
    d32,
    r11g11b10f,
};

struct FormatInfo {
    Format format;
    std::string_view name;
    std::uint32_t texel_bytes;
    bool depth;
};

/// In the order of the enumeration.
inline constexpr FormatInfo formats[] = {
    {Format::rgba8, "rgba8", 4, false},     {Format::rgb10a2, "rgb10a2", 4, false},
    {Format::rg16ui, "rg16ui", 4, false},   {Format::rgba16, "rgba16", 8, false},
    {Format::rgba16f, "rgba16f", 8, false}, {Format::r32f, "r32f", 4, false},
    {Format::r32ui, "r32ui", 4, false},     {Format::rgba32f, "rgba32f", 16, false},
    {Format::d32, "d32", 4, true},          {Format::r11g11b10f, "r11g11b10f", 4, false},
};

constexpr const FormatInfo& info(Format format) {
    return formats[static_cast<std::size_t>(format)];
}

/// Whether its texels are whole numbers.
constexpr bool is_integer(Format format) {
    return format == Format::rg16ui || format == Format::r32ui;
}

/// The shape of an image. A `depth` makes it three-dimensional (sampler3D), `layers` an array
/// (sampler2DArray); with neither it is a plain sampler2D.
struct ImageDesc {
    Format format = Format::rgba16f;
    std::uint32_t width = 1, height = 1, depth = 0, layers = 0;

    std::uint64_t bytes() const {
        return std::uint64_t{info(format).texel_bytes} * width * height * (depth > 0 ? depth : 1) *
               (layers > 0 ? layers : 1);
    }
    friend bool operator==(const ImageDesc&, const ImageDesc&) = default;
};

/// How a shader reads an image: texel centres sit at half-integers over the image's size.
enum class Sampler : std::uint8_t {
    nearest_clamp,
    linear_clamp,
    linear_zero,    ///< linear; outside the image all channels read 0
    linear_repeat,  ///< linear; the image repeats
    shadow_compare, ///< for a depth image: 1 where the reference lies in front, filtered 2x2
};
inline constexpr int sampler_count = 5;

/// What stands in for an image that the frame withholds.
enum class Neutral : std::uint8_t {
    black,         ///< 1x1, all channels 0
    white,         ///< 1x1, all channels 1
    black_3d,      ///< 1x1x1, all channels 0
    lit,           ///< 1x1 depth array of one layer at the far plane: nothing is in shadow
    black_integer, ///< 1x1 of whole numbers, 0
    no_buffer,     ///< a storage or uniform buffer of zeros
};
inline constexpr int neutral_count = 6;

/// Which descriptor a shader sees.
enum class BindingType : std::uint8_t {
    none, ///< no descriptor: attachments, index and indirect buffers, fills
    sampled_image,
    storage_image,
    storage_buffer,
    uniform_buffer,
};

struct RasterState {
    enum class Cull : std::uint8_t { none, back, front };
    Cull cull = Cull::back; ///< front faces wind counter-clockwise in the picture
    bool depth_test = true; ///< nearer or equal passes; 0 is near, 1 far
    bool depth_write = true;
    float depth_bias_constant = 0;
    float depth_bias_slope = 0;
    bool draws_lines = false; ///< triangles as their edges
    bool blends = false;      ///< colours, times their coverage already, go over what stands there
    friend auto operator<=>(const RasterState&, const RasterState&) = default;
};

} // namespace preview
