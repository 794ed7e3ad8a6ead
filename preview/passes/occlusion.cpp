#include "preview/passes/occlusion.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace preview {

namespace {

/// PCG3D: Jarzynski and Olano 2020, "Hash functions for GPU rendering".
glm::uvec3 hash(glm::uvec3 v) {
    const auto mix = [](glm::uvec3& bits) {
        bits.x += bits.y * bits.z;
        bits.y += bits.z * bits.x;
        bits.z += bits.x * bits.y;
    };
    v = v * 1664525U + 1013904223U;
    mix(v);
    v = {v.x ^ v.x >> 16U, v.y ^ v.y >> 16U, v.z ^ v.z >> 16U};
    mix(v);
    return v;
}

/// Of 24 bits, below 1.
double unit_of(std::uint32_t bits) {
    return (bits >> 8U) * 0x1p-24;
}

std::uint32_t reversed(std::uint32_t bits) {
    std::uint32_t out = 0;
    for (unsigned i = 0; i < 32; ++i) {
        out |= (bits >> i & 1U) << (31U - i);
    }
    return out;
}

/// For each of 4x4 pixels `samples` places in the frame of tangent, bitangent and normal, of a
/// hemisphere of radius 1. Made here because sines and cosines of a GPU
/// may be a thousandth off, which moves points to other texels.
std::vector<glm::vec4> points(std::uint32_t samples) {
    constexpr double golden = 0.61803398875;
    const auto fraction = [](double x) { return x - std::floor(x); };
    std::vector<glm::vec4> out;
    for (std::uint32_t cell = 0; cell < 16; ++cell) {
        const glm::uvec3 bits = hash({cell % 4, cell / 4, 0});
        for (std::uint32_t i = 0; i < samples; ++i) {
            const double share = (i + unit_of(bits.x)) / samples;
            const double turn = 2 * std::numbers::pi * fraction(i * golden + unit_of(bits.y));
            const double root = fraction(unit_of(reversed(i)) + unit_of(bits.z));
            const double reach = root * root, across = reach * std::sqrt(share);
            out.emplace_back(across * std::cos(turn), across * std::sin(turn),
                             reach * std::sqrt(1 - share), 0);
        }
    }
    return out;
}

/// A pass that makes an image of `size` from `source`, an image of cells, and the surfaces.
ImageHandle filtered(Graph& graph, const SceneHandles& scene, const GBuffer& surfaces,
                     ImageHandle source, Size size, const OcclusionInputs& inputs,
                     std::string_view name, std::string_view shader,
                     std::initializer_list<std::uint32_t> constants) {
    const Size cells = size_of(graph, source);
    Pass pass = graph.compute(name, shader);
    std::vector<std::uint32_t> words{inputs.cell};
    words.insert(words.end(), constants);
    pass.constants(std::move(words));
    pass.uniform(scene.view);
    pass.read(surfaces.depth);
    pass.read(surfaces.normal);
    pass.read(source);
    const ImageHandle out = pass.write(graph.image(name, {Format::r32f, size.width, size.height}));
    pass.push(inputs.radius);
    pass.dispatch_over(cells.width, cells.height);
    return out;
}

} // namespace

ImageHandle add_occlusion(Graph& graph, const SceneHandles& scene, const GBuffer& surfaces,
                          const OcclusionInputs& inputs) {
    const Size size = size_of(graph, surfaces.depth);
    Pass pass = graph.compute("ambient occlusion", "occlusion.comp");
    pass.constants({inputs.cell, inputs.samples});
    pass.uniform(scene.view);
    pass.read(surfaces.depth);
    pass.read(surfaces.normal);
    const auto cells_along = [&](std::uint32_t pixels) {
        return (pixels + inputs.cell - 1) / inputs.cell;
    };
    const Size cells{cells_along(size.width), cells_along(size.height)};
    ImageHandle out =
        pass.write(graph.image("ambient occlusion", {Format::r32f, cells.width, cells.height}));
    pass.storage(graph.data("points of the occlusion",
                            std::as_bytes(std::span<const glm::vec4>(points(inputs.samples)))));
    pass.push(std::array{inputs.radius, inputs.strength});
    pass.dispatch_over(cells.width, cells.height);
    out = filtered(graph, scene, surfaces, out, cells, inputs, "ambient occlusion blurred along x",
                   "occlusion_blur.comp", {1});
    out = filtered(graph, scene, surfaces, out, cells, inputs, "ambient occlusion blurred along y",
                   "occlusion_blur.comp", {0});
    return inputs.cell == 1 ? out
                            : filtered(graph, scene, surfaces, out, size, inputs,
                                       "ambient occlusion enlarged", "occlusion_enlarge.comp", {});
}

} // namespace preview
