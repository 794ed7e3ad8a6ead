// How many lights the pixels of a frame evaluate, and that those left out change none of them.
#include "tests/preview/frame/frame_fixture.h"

#include <numeric>

namespace preview {
namespace {

class LightCountsTest : public FrameTest {
  protected:
    Executor executor_{device()};

    static FrameSettings settings_of(const Scene& scene, bool is_forced) {
        FrameSettings out = settings_for(scene);
        out.format = Format::rgba32f;
        out.force_all = is_forced;
        return out;
    }

    /// Of each pixel.
    std::vector<float> counts(const Loaded& loaded, bool is_forced) {
        FrameSettings settings = settings_of(loaded.scene, is_forced);
        settings.view = debug_view_named("lights");
        settings.shows_numbers = true;
        const Rendered rendered = render_frame(executor_, loaded.inputs(), settings);
        std::vector<float> out;
        for (std::size_t at = 0; at < rendered.values.size(); at += 4) {
            out.push_back(rendered.values[at]);
        }
        return out;
    }

    std::vector<float> depths(const Loaded& loaded) {
        FrameSettings settings = settings_of(loaded.scene, false);
        settings.view = debug_view_named("depth");
        settings.shows_numbers = true;
        const Rendered rendered = render_frame(executor_, loaded.inputs(), settings);
        std::vector<float> out;
        for (std::size_t at = 0; at < rendered.values.size(); at += 4) {
            out.push_back(rendered.values[at]); // 0 where there is nothing
        }
        return out;
    }

    void expect_same_picture(const Loaded& loaded) {
        const auto picture = [&](bool is_forced) {
            return render_frame(executor_, loaded.inputs(), settings_of(loaded.scene, is_forced))
                .values;
        };
        EXPECT_EQ(picture(false), picture(true));
    }
};

double sum_of(const std::vector<float>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 0.0);
}

/// Balls before a sky, with so many small lamps that end soon, far and near.
Scene lamps(std::size_t count) {
    Scene scene = scene_at(*scene_named("materials"), 0);
    scene.lights.clear();
    for (std::size_t i = 0; i < count; ++i) {
        const auto t = static_cast<float>(i);
        PointLight lamp;
        lamp.name = std::to_string(i);
        lamp.position = {std::fmod(t * 1.7F, 7.0F) - 3.5F, std::fmod(t * 1.1F, 4.0F) - 2, 0.7F};
        lamp.intensity = {1, 2, 3};
        lamp.reach = 0.6F + 0.05F * std::fmod(t, 5.0F);
        scene.lights.push_back(lamp);
    }
    return scene;
}

TEST_F(LightCountsTest, lights_with_a_reach_are_evaluated_where_they_reach) {
    const Loaded loaded(lamps(40));
    const std::vector<float> all = counts(loaded, true), fewer = counts(loaded, false),
                             depth = depths(loaded);
    std::size_t surfaces = 0, dark = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_EQ(all[i], depth[i] > 0 ? 40 : 0) << i; // the sky evaluates none
        ASSERT_LE(fewer[i], all[i]);
        surfaces += depth[i] > 0 ? 1 : 0;
        dark += depth[i] > 0 && fewer[i] == 0 ? 1 : 0;
    }
    EXPECT_GT(surfaces, 3000U);
    EXPECT_LT(dark, surfaces);
    EXPECT_LT(sum_of(fewer), 0.35 * sum_of(all));
    expect_same_picture(loaded);
    // Without a reach each lights everything.
    Scene endless = loaded.scene;
    for (PointLight& light : endless.lights) {
        light.reach = 0;
    }
    EXPECT_EQ(counts(Loaded(endless), false), all);
}

TEST_F(LightCountsTest, unlit_surfaces_evaluate_none_also_beside_lit_ones) {
    Scene scene = lamps(12);
    for (std::size_t i = 0; i < scene.materials.size(); i += 2) {
        scene.materials[i].detail.is_unlit = true;
    }
    const Loaded loaded(scene);
    const std::vector<float> all = counts(loaded, true), fewer = counts(loaded, false);
    const std::vector<float> lit = counts(Loaded(lamps(12)), true);
    EXPECT_LT(sum_of(all), 0.7 * sum_of(lit));
    EXPECT_GT(sum_of(all), 0.3 * sum_of(lit));
    EXPECT_LT(sum_of(fewer), sum_of(all));
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_TRUE(all[i] == 0 || all[i] == 12) << i;
        ASSERT_LE(fewer[i], all[i]);
    }
    expect_same_picture(loaded);
}

TEST_F(LightCountsTest, a_light_that_is_off_or_black_is_left_out_with_its_reason) {
    Scene scene = lamps(10);
    scene.lights[3].intensity = glm::vec3(0);
    scene.lights[4].is_on = false;
    scene.lights[5].shape = PointLight::Shape::rod;
    scene.lights[5].extent = {0.2F, 0, 0};
    scene.lights[5].intensity = glm::vec3(0);
    for (PointLight& light : scene.lights) {
        light.reach = 0;
    }
    const Loaded loaded(scene);
    const std::vector<float> some = counts(loaded, false);
    EXPECT_EQ(*std::max_element(some.begin(), some.end()), 7);
    const Rendered rendered = render_frame(executor_, loaded.inputs(), settings_of(scene, false));
    for (const char* line : {"light 3", "light 4", "light 5"}) {
        EXPECT_NE(rendered.explanation.find("left out  " + std::string(line)), std::string::npos)
            << rendered.explanation;
    }
    EXPECT_EQ(rendered.explanation.find("left out  light 6"), std::string::npos);
    expect_same_picture(loaded);
}

} // namespace
} // namespace preview
