// The blur of what a lens is not focused on.
#include "preview/effects/all.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace preview::effect {
namespace {

/// shaders/common/disc.glsl
constexpr int most_rings = 6;
/// Sides of cells of pixels.
constexpr int most_cell = 4;
constexpr std::size_t most_disc_points = 1 + 4 * most_rings * (most_rings + 1);

constexpr lutlib::Parameter depth_of_field_parameters[] = {
    {.name = "strength", .flag = "strength", .label = "Strength", .fallback = 1},
    {.name = "focus",
     .flag = "focus",
     .label = "Focus; 0: at the point",
     .unit = "m",
     .max = 1000,
     .fallback = 0},
    {.name = "at-x", .flag = "at-x", .label = "Point, of the width", .fallback = 0.5},
    {.name = "at-y", .flag = "at-y", .label = "Point, of the height", .fallback = 0.5},
    {.name = "aperture",
     .flag = "aperture",
     .label = "Aperture f/N",
     .min = 0.5,
     .max = 64,
     .fallback = 0.7},
    {.name = "sensor",
     .flag = "sensor",
     .label = "Height of the sensor",
     .unit = "mm",
     .min = 1,
     .max = 200,
     .fallback = 24},
    {.name = "largest",
     .flag = "largest",
     .label = "Largest circle",
     .unit = "1/1000 h",
     .min = 1,
     .max = 100,
     .fallback = 40},
    {.name = "rings",
     .flag = "rings",
     .label = "Rings of points",
     .min = 1,
     .max = most_rings,
     .fallback = 3},
    {.name = "cell",
     .flag = "cell",
     .label = "Pixels a side that are blurred as one",
     .min = 1,
     .max = most_cell,
     .fallback = 2},
};

/// shaders/common/lens.glsl
struct Lens {
    float scale, focal, near_plane, focus, largest;
    std::int32_t place_x = 0, place_y = 0;
};

Lens lens_of(const lutlib::Values& values, const EffectDepth& depth, std::uint32_t rows) {
    const float sensor = number_at(values, 5) / 1000;
    Lens out{};
    out.focal = sensor / 2 * depth.focal;
    out.scale = number_at(values, 0) * static_cast<float>(rows) / 2 * out.focal * out.focal /
                (number_at(values, 4) * sensor);
    out.near_plane = depth.near_plane;
    out.focus = number_at(values, 1) > 0 ? 1 / number_at(values, 1) : -1;
    out.largest = number_at(values, 6) / 1000 * static_cast<float>(rows) / 2;
    return out;
}

/// Of any texel that the camera may see, in texels.
float largest_radius(const Lens& lens, float nearest_depth) {
    const float nearest = 1 / std::max(nearest_depth, lens.near_plane),
                most = std::min(0.5F / lens.focal, nearest);
    const auto of_focus = [&](float focus) {
        return lens.scale / (1 - lens.focal * focus) * std::max(focus, nearest - focus);
    };
    const float focus = std::clamp(lens.focus, 0.0F, most);
    return std::min(lens.largest,
                    lens.focus < 0 ? std::max(of_focus(0), of_focus(most)) : of_focus(focus));
}

std::string_view idle_because(const lutlib::Values& values, const EffectDepth& depth,
                              std::uint32_t rows) {
    return largest_radius(lens_of(values, depth, rows), depth.nearest) < 0.25F
               ? "its largest circle is under half a pixel"
               : "";
}

std::string_view idle_in_depth_of_field(const lutlib::Values& values, std::size_t parameter,
                                        double /*seconds*/) {
    const bool is_point = parameter == 2 || parameter == 3;
    return is_point && number_at(values, 1) > 0 ? "focus says how far it is" : "";
}

/// As many as the shader has room for, of which it takes those of its rings.
std::vector<std::array<float, 4>> disc_points(int rings) {
    std::vector<std::array<float, 4>> out{{0, 0, 0, 0}};
    for (int ring = 1; ring <= rings; ++ring) {
        const double radius = 2.0 * ring / (2 * rings + 1);
        for (int i = 0; i < 8 * ring; ++i) {
            const double turn = 2 * std::numbers::pi * (i + 0.5 * (ring % 2)) / (8 * ring);
            out.push_back({static_cast<float>(radius * std::cos(turn)),
                           static_cast<float>(radius * std::sin(turn)), static_cast<float>(radius),
                           0});
        }
    }
    out.resize(most_disc_points);
    return out;
}

/// Of cells of pixels.
struct Layers {
    std::uint32_t cell = 2; ///< side, in pixels
    ImageHandle rest{}, near{}, near_radii{}, tiles{};
};

Layers add_layers(Graph& graph, const EffectInput& in, const Lens& lens, std::uint32_t cell) {
    const ImageDesc desc = graph.image_desc(in.picture);
    const std::uint32_t width = (desc.width + cell - 1) / cell,
                        height = (desc.height + cell - 1) / cell;
    Pass pass = graph.compute("depth-of-field layers", "depth_of_field_layers.comp");
    pass.constants({cell});
    pass.read(in.picture);
    pass.read(in.depth.image);
    Layers out{.cell = cell};
    out.rest = pass.write(graph.image("not before the focus", {Format::rgba16f, width, height}));
    out.near = pass.write(graph.image("before the focus", {Format::rgba16f, width, height}));
    out.near_radii =
        pass.write(graph.image("circles before the focus", {Format::r32f, width, height}));
    out.tiles = pass.write(
        graph.image("largest circles", {Format::r32f, (width + 15) / 16, (height + 15) / 16}));
    pass.push(lens);
    pass.dispatch_over(width, height);
    return out;
}

/// Replaces what is to be blurred by what is.
void blur(Graph& graph, Layers& layers, float largest, int rings) {
    const ImageDesc desc = graph.image_desc(layers.rest), tiles = graph.image_desc(layers.tiles);
    Pass pass = graph.compute("depth-of-field blur", "depth_of_field_blur.comp");
    pass.constants({layers.cell, static_cast<std::uint32_t>(rings)});
    pass.read(layers.rest);
    pass.read(layers.near);
    pass.read(layers.near_radii);
    pass.read(layers.tiles);
    const std::vector<std::array<float, 4>> points = disc_points(rings);
    pass.uniform(graph.data("disc", std::as_bytes(std::span(points))));
    const ImageHandle rest = pass.write(graph.image("not before the focus, blurred", desc));
    const ImageHandle near = pass.write(graph.image("before the focus, blurred", desc));
    const ImageHandle reaches = pass.write(graph.image("reaches", tiles));
    pass.push(largest / static_cast<float>(layers.cell));
    pass.dispatch_over(desc.width, desc.height);

    Pass fill = graph.compute("depth-of-field fill", "depth_of_field_fill.comp");
    fill.read(rest);
    fill.read(near);
    fill.read(reaches);
    layers.rest = fill.write(graph.image("not before the focus, filled", desc));
    layers.near = fill.write(graph.image("before the focus, filled", desc));
    fill.dispatch_over(desc.width, desc.height);
}

ImageHandle add_depth_of_field(Graph& graph, const EffectInput& in, const lutlib::Values& values) {
    const ImageDesc desc = graph.image_desc(in.picture);
    Lens lens = lens_of(values, in.depth, desc.height);
    const auto texel = [](float share, std::uint32_t length) {
        return std::min(static_cast<std::int32_t>(share * static_cast<float>(length)),
                        static_cast<std::int32_t>(length) - 1);
    };
    lens.place_x = texel(number_at(values, 2), desc.width);
    lens.place_y = texel(number_at(values, 3), desc.height);
    const auto whole = [&](std::size_t parameter, int most) {
        return std::clamp(static_cast<int>(std::lround(number_at(values, parameter))), 1, most);
    };
    Layers layers = add_layers(graph, in, lens, static_cast<std::uint32_t>(whole(8, most_cell)));
    blur(graph, layers, lens.largest, whole(7, most_rings));
    Pass pass = graph.compute("depth-of-field", "depth_of_field.comp");
    pass.constants({layers.cell});
    pass.read(in.picture);
    pass.read(in.depth.image);
    pass.read(layers.rest);
    pass.sample(layers.near, Sampler::linear_clamp);
    const ImageHandle out = pass.write(graph.image("focused", desc));
    pass.push(lens);
    pass.dispatch_over(desc.width, desc.height, many_each);
    return out;
}

} // namespace

const PostEffect depth_of_field{
    .name = "depth-of-field",
    .label = "Depth of field",
    .help = "Blurs what a lens with this aperture and sensor is not focused on",
    .reference = "thin lens: circle on the sensor f/N f/(z_f - f) |1 - z_f/z|; layers apart after "
                 "Jimenez 2014, Next Generation Post Processing in Call of Duty",
    .stage = Stage::hdr,
    .parameters = depth_of_field_parameters,
    .needs_depth = true,
    .idle_because = idle_because,
    .idle_parameter = idle_in_depth_of_field,
    .add = add_depth_of_field};

} // namespace preview::effect
