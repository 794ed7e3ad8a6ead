// What stays of a state when what it shows is read again.
#include "preview/window/opening.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/png.h"
#include "preview/frame/shown.h"
#include "tests/lutlib/io/scratch.h"

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

TEST(ShownAgain, is_what_its_files_hold_now_with_the_surroundings_that_it_had) {
    const lutlib::ScratchFolder folder;
    const std::string path = folder.file("picture.png");
    const auto write_grey = [&](std::uint16_t code, int width) {
        lutlib::io::PngImage image;
        image.width = width;
        image.height = 1;
        image.samples.assign(3 * static_cast<std::size_t>(width), code);
        lutlib::io::write_file(path, lutlib::io::write_png(image));
    };
    write_grey(0, 2);
    const Shown picture = load_shown(path, 0);
    Shown scene = load_shown("plain", 3);
    load_surroundings(scene, path);
    EXPECT_EQ(picture.files, std::vector{path});
    EXPECT_EQ(scene.files, std::vector{path});
    EXPECT_TRUE(load_shown("plain", 0).files.empty());
    write_grey(255, 4);
    EXPECT_EQ(load_again(picture).picture->size.width, 4U);
    EXPECT_EQ(load_again(picture).picture->rgba[0], 1);
    const Shown again = load_again(scene);
    EXPECT_TRUE(again.scene);
    EXPECT_EQ(again.seconds, 3);
    EXPECT_EQ(again.surroundings->rgba[0], 1);
    lutlib::io::write_file(path, "no picture");
    EXPECT_THROW(load_again(picture), lutlib::Error);
    EXPECT_THROW(load_again(scene), lutlib::Error);
}

} // namespace
} // namespace preview
