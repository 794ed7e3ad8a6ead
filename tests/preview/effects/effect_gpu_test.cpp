// Every effect's shader against its twin in double.
#include "preview/effects/effect.h"
#include "preview/reference/fxaa.h"
#include "preview/reference/vignette.h"
#include "tests/preview/passes/finish_fixture.h"

namespace preview {
namespace {

using lutlib::Rgb;
using lutlib::RgbD;
using reference::Image;

/// A disc and a slope of another colour, both with some texture.
Image scene_of_edges() {
    Image picture(135, 67);
    for (int y = 0; y < 67; ++y) {
        for (int x = 0; x < 135; ++x) {
            const bool inside = (x - 60) * (x - 60) + (y - 30) * (y - 30) < 500 || 3 * y > x + 90;
            const double texture = 0.05 * ((x * 7 + y * 13) % 11) / 11.0;
            picture.at(x, y) =
                inside ? RgbD{0.9, 0.7 - texture, 0.2} : RgbD{0.1, 0.15 + texture, 0.3};
        }
    }
    return picture;
}

class EffectTest : public FinishTest {
  protected:
    /// `sides` pictures stand side by side in `picture`.
    static std::vector<Rgb> run(const std::string& use_text, const Image& picture, int sides = 1) {
        const EffectUse use = parse_use(use_text);
        const gpu::Image image = image_of(picture);
        Graph graph;
        const ImageHandle out = use.effect->add(graph,
                                                {graph.import("picture", image, image.desc()),
                                                 static_cast<std::uint32_t>(picture.width / sides)},
                                                use.values);
        graph.present(out);
        return colors_of(run_and_read<float>(graph, out));
    }

    /// How many values are further from those wanted than rounding explains.
    static std::size_t apart(const std::vector<Rgb>& got, const Image& wanted) {
        std::size_t out = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                out += std::abs(static_cast<double>(got[i][c]) - wanted.pixels[i][c]) > 1e-5;
            }
        }
        return out;
    }
};

TEST_F(EffectTest, fxaa_equals_its_twin_in_double) {
    const Image picture = scene_of_edges();
    for (const double strength : {1.0, 0.5}) {
        const Image wanted = reference::fxaa(picture, strength);
        const auto got = run("fxaa:strength=" + std::to_string(strength), picture);
        std::size_t changed = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            changed += wanted.pixels[i] != picture.pixels[i];
        }
        EXPECT_GT(changed, 100U);
        // Comparisons that hang on a rounding may fall either way.
        EXPECT_LE(apart(got, wanted), 3 * got.size() / 1000) << strength;
    }
}

TEST_F(EffectTest, the_vignette_equals_its_twin_in_double) {
    const Image light = scene_of_edges();
    for (const double strength : {1.0, 0.3}) {
        for (const double angle : {10.0, 60.0, 150.0}) {
            const auto got = run("vignette:strength=" + std::to_string(strength) +
                                     ",angle=" + std::to_string(angle),
                                 light);
            EXPECT_EQ(apart(got, reference::vignette(light, strength, angle)), 0U)
                << strength << ' ' << angle;
        }
    }
}

TEST_F(EffectTest, the_vignette_of_two_pictures_side_by_side_is_that_of_each) {
    Image pair(60, 20), one(30, 20);
    for (RgbD& pixel : pair.pixels) {
        pixel = {0.5, 2, 8};
    }
    for (RgbD& pixel : one.pixels) {
        pixel = {0.5, 2, 8};
    }
    const auto together = run("vignette", pair, 2);
    const auto alone = run("vignette", one);
    for (std::size_t i = 0; i < together.size(); ++i) {
        EXPECT_EQ(together[i], alone[i / 60 * 30 + i % 30]) << i;
    }
}

} // namespace
} // namespace preview
