// What stays of a state when what it shows is read again.
#include "preview/window/opening.h"

#include "preview/frame/shown.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

std::shared_ptr<const Shown> scene_with(const std::vector<PointLight>& lights, float azimuth) {
    Shown shown;
    shown.name = "model.glb";
    shown.scene.emplace();
    shown.scene->lights = lights;
    shown.scene->orbit.azimuth = azimuth;
    return std::make_shared<const Shown>(std::move(shown));
}

PointLight light_of(float intensity) {
    PointLight out;
    out.intensity = glm::vec3(intensity);
    return out;
}

editor::State state_of(std::shared_ptr<const Shown> shown) {
    editor::State out = editor::initial_state();
    take_shown(out, std::move(shown));
    return out;
}

TEST(ShownAgain, keeps_camera_finish_and_effects) {
    editor::State state = state_of(scene_with({light_of(1)}, 10));
    state.orbit.azimuth = 77;
    state.exposure = 1.5F;
    state.effects.clear();
    state.surroundings.kind = SurroundingsKind::sky;
    editor::State expected = state;
    const auto fresh = scene_with({light_of(1)}, 20);
    expected.shown = fresh;
    take_shown_again(state, fresh);
    EXPECT_TRUE(state == expected);
}

TEST(ShownAgain, follows_the_files_lights_until_a_person_has_changed_them) {
    editor::State state = state_of(scene_with({light_of(1)}, 0));
    take_shown_again(state, scene_with({light_of(2), light_of(3)}, 0));
    EXPECT_EQ(state.lights, (std::vector{light_of(2), light_of(3)}));
    state.lights[0].is_on = false;
    const std::vector<PointLight> changed = state.lights;
    take_shown_again(state, scene_with({light_of(4)}, 0));
    EXPECT_EQ(state.lights, changed);
}

TEST(ShownAgain, has_light_as_the_picture_has_now) {
    const auto picture = [](bool display_encoded) {
        Shown shown;
        shown.name = "picture.tif";
        shown.picture = ShownPicture{{1, 1}, {0, 0, 0, 1}, display_encoded, false};
        return std::make_shared<const Shown>(std::move(shown));
    };
    editor::State state = state_of(picture(true));
    EXPECT_FALSE(state.picture.has_light);
    take_shown_again(state, picture(false));
    EXPECT_TRUE(state.picture.has_light);
}

} // namespace
} // namespace preview
