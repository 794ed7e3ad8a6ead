// What the tests of the finishing passes share: colours as an image, images as colours.
#pragma once

#include "lutlib/metrics/samples.h"
#include "preview/look/gpu_look.h"
#include "preview/passes/finish.h"
#include "preview/reference/image.h"
#include "tests/preview/graph/gpu_test.h"

#include <cmath>
#include <limits>

namespace preview {

/// The colours on which `lutconv verify` compares, and the values that break things. Beyond 17
/// nodes the lattice's own are left to chance, for the sake of time.
inline std::vector<lutlib::Rgb> test_colors(int lattice_size) {
    std::vector<lutlib::Rgb> colors =
        lutlib::sample_colors(lattice_size, {1024, 20000, lattice_size <= 17});
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const float odd[]{0,          1, 0.5F,  -0.0F, -1,  -1e30F, 1e-30F,
                      1.0000001F, 7, 65504, 1e30F, inf, -inf,   nan};
    for (const float r : odd) {
        for (const float g : odd) {
            for (const float b : odd) {
                colors.push_back({r, g, b});
            }
        }
    }
    return colors;
}

class FinishTest : public GpuTest {
  protected:
    static constexpr std::uint32_t colors_a_row = 256;

    static gpu::Image image_of(const std::vector<lutlib::Rgb>& colors,
                               std::uint32_t width = colors_a_row) {
        const auto height = static_cast<std::uint32_t>((colors.size() + width - 1) / width);
        std::vector<float> texels(std::size_t{4} * width * height);
        for (std::size_t i = 0; i < colors.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) {
                texels[4 * i + c] = c < 3 ? colors[i][c] : 1;
            }
        }
        return upload({Format::rgba32f, width, height}, texels);
    }

    static gpu::Image image_of(const reference::Image& picture) {
        std::vector<lutlib::Rgb> colors;
        for (const lutlib::RgbD& pixel : picture.pixels) {
            colors.push_back(lutlib::to_float(pixel));
        }
        return image_of(colors, static_cast<std::uint32_t>(picture.width));
    }

    static std::vector<lutlib::Rgb> colors_of(const std::vector<float>& texels) {
        std::vector<lutlib::Rgb> colors;
        for (std::size_t i = 0; i + 3 < texels.size(); i += 4) {
            colors.push_back({texels[i], texels[i + 1], texels[i + 2]});
        }
        return colors;
    }

    /// The colours through the finishing pass, into floats.
    static std::vector<lutlib::Rgb> finished(const std::vector<lutlib::Rgb>& colors,
                                             const GpuLook* look, FinishSettings settings) {
        const gpu::Image image = image_of(colors);
        settings.format = Format::rgba32f;
        Graph graph;
        const ImageHandle source = graph.import("colours", image, image.desc());
        const ImageHandle out = add_finish(graph, {source, {}, look, nullptr, settings}).picture;
        graph.present(out);
        auto result = colors_of(run_and_read<float>(graph, out));
        result.resize(colors.size());
        return result;
    }

    /// The same into 8-bit codes.
    static std::vector<std::uint8_t> finished_codes(const std::vector<lutlib::Rgb>& colors,
                                                    const GpuLook* look, FinishSettings settings) {
        const gpu::Image image = image_of(colors);
        settings.format = Format::rgba8;
        Graph graph;
        const ImageHandle source = graph.import("colours", image, image.desc());
        const ImageHandle out = add_finish(graph, {source, {}, look, nullptr, settings}).picture;
        graph.present(out);
        return run_and_read<std::uint8_t>(graph, out);
    }
};

} // namespace preview
