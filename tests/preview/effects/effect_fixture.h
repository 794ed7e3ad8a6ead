// Effects alone, over a picture in double.
#pragma once

#include "preview/effects/effect.h"
#include "preview/reference/image.h"
#include "tests/preview/passes/finish_fixture.h"

namespace preview {

/// What an effect is given beside the picture.
struct Given {
    int sides = 1; ///< pictures that stand side by side
    double seconds = 0;
    std::vector<float> depth{}; ///< of each pixel of a side; empty: there is none
};

class EffectTest : public FinishTest {
  protected:
    /// One executor for all, whose pipelines take longest to make.
    static Executor& executor() {
        static Executor made(device());
        return made;
    }
    static std::vector<lutlib::Rgb> run(const std::string& use_text,
                                        const reference::Image& picture, const Given& given = {}) {
        const EffectUse use = parse_use(use_text);
        const gpu::Image image = image_of(picture);
        const auto width = static_cast<std::uint32_t>(picture.width / given.sides);
        const auto height = static_cast<std::uint32_t>(picture.height);
        const gpu::Image depth = upload(
            {Format::r32f, given.depth.empty() ? 1U : width, given.depth.empty() ? 1U : height},
            given.depth.empty() ? std::vector<float>{1} : given.depth);
        Graph graph;
        EffectInput in{graph.import("picture", image, image.desc()), width, given.seconds};
        if (use.effect->needs_depth) {
            in.depth = {graph.import("depth", depth, depth.desc()), 0.1F, 0.1F, 2};
        }
        const ImageHandle out = use.effect->add(graph, in, use.values);
        graph.present(out);
        executor().render(graph);
        return colors_of(as<float>(executor().read_image(out)));
    }

    /// How many values are further from those wanted than rounding explains.
    static std::size_t apart(const std::vector<lutlib::Rgb>& got, const reference::Image& wanted) {
        std::size_t out = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                out += std::abs(static_cast<double>(got[i][c]) - wanted.pixels[i][c]) > 1e-5;
            }
        }
        return out;
    }
};

} // namespace preview
