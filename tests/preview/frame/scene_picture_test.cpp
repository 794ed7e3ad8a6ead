// What built-in scenes promise of their pictures.
#include "preview/frame/usual_finish.h"
#include "preview/scene/swatches.h"
#include "tests/preview/frame/frame_fixture.h"

#include <algorithm>
#include <array>
#include <glm/vec4.hpp>

namespace preview {
namespace {

class ScenePicture : public FrameTest {
  protected:
    /// As a person sees it who asks for nothing but the scene.
    Rendered usual_picture(const char* name, const Loaded& loaded) const {
        FrameSettings settings;
        settings.output = size;
        settings.orbit = loaded.scene.orbit;
        settings.tonemap = usual_finish(name).tonemap;
        settings.bloom = usual_finish(name).bloom;
        set_usual(settings.effects, true);
        Executor executor(device());
        return render_frame(executor, loaded.inputs(), settings);
    }
};

/// The codes where the camera sees the object's middle.
std::array<int, 3> codes_at(const Rendered& rendered, const Scene& scene, const Object& object) {
    const auto width = static_cast<float>(rendered.size.width);
    const auto height = static_cast<float>(rendered.size.height);
    const Camera camera = camera_of(scene.orbit, width / height);
    const glm::vec4 clip = camera.projection * camera.view * object.transform[3];
    const auto x = static_cast<std::size_t>((clip.x / clip.w * 0.5F + 0.5F) * width);
    const auto y = static_cast<std::size_t>((clip.y / clip.w * 0.5F + 0.5F) * height);
    const std::size_t texel = 4 * (y * rendered.size.width + x);
    return {rendered.rgba[texel], rendered.rgba[texel + 1], rendered.rgba[texel + 2]};
}

TEST_F(ScenePicture, patches_of_the_chart_have_exactly_their_published_codes) {
    const Loaded loaded(scene_at(*scene_named("chart"), 0));
    const Rendered rendered = usual_picture("chart", loaded);
    const auto expect_code = [&](glm::vec3 light, std::array<int, 3> codes, std::string_view name) {
        int found = 0;
        for (const Object& object : loaded.scene.objects) {
            if (loaded.scene.materials[object.material].emission == light) {
                EXPECT_EQ(codes_at(rendered, loaded.scene, object), codes) << name;
                ++found;
            }
        }
        EXPECT_EQ(found, 1) << name;
    };
    for (const auto& swatches : {std::span<const Swatch>(color_checker), {skin_tones}}) {
        for (const Swatch& swatch : swatches) {
            expect_code(linear_of(swatch), {swatch.srgb[0], swatch.srgb[1], swatch.srgb[2]},
                        swatch.name);
        }
    }
    // IEC 61966-2-1: 18 % is code 117.65, two stops less 60.4, and nothing shines brighter than 1.
    expect_code(glm::vec3(0.18F), {118, 118, 118}, "18 %");
    expect_code(glm::vec3(0.18F / 4), {60, 60, 60}, "-2 stops");
    expect_code(glm::vec3(0.18F * 8), {255, 255, 255}, "+3 stops");
}

TEST_F(ScenePicture, the_sample_reaches_from_black_to_white) {
    const Loaded loaded(scene_at(*scene_named("sample"), 0));
    const Rendered rendered = usual_picture("sample", loaded);
    int darkest = 255;
    int brightest = 0;
    for (std::size_t at = 0; at < rendered.rgba.size(); at += 4) {
        const auto [low, high] =
            std::minmax({rendered.rgba[at], rendered.rgba[at + 1], rendered.rgba[at + 2]});
        darkest = std::min<int>(darkest, high);
        brightest = std::max<int>(brightest, low);
    }
    EXPECT_LT(darkest, 4);
    EXPECT_GT(brightest, 250);
}

} // namespace
} // namespace preview
