// --light: what it sets and what it refuses.
#include "preview/cli/light_edit.h"

#include "lutlib/error.h"
#include "preview/scene/light_controls.h"
#include "preview/scene/scene.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

void expect_near(glm::vec3 got, glm::vec3 want, float bound) {
    EXPECT_LT(glm::length(got - want), bound) << got.x << " " << got.y << " " << got.z << ", not "
                                              << want.x << " " << want.y << " " << want.z;
}

TEST(LightEdit, takes_a_value_for_every_control_and_keeps_the_rest) {
    for (const LightControl& control : light_controls()) {
        Scene scene = scene_at(*scene_named("studio"), 0);
        const std::vector<PointLight> before = scene.lights;
        const std::string value = components(control.kind) == 1 ? "0" : "0.25,0.5,1";
        const bool is_flag = control.kind == LightControl::Kind::flag;
        edit_light(scene.lights, "key." + std::string(control.name) + "=" +
                                     (is_flag || value != "0" ? value : "3"));
        EXPECT_FALSE(scene.lights[0] == before[0]) << control.name;
        const glm::vec3 got = control.get(scene.lights[0]);
        EXPECT_NEAR(got.x, is_flag ? 0 : value == "0" ? 3 : 0.25F, 1e-5F) << control.name;
        for (const LightControl& other : light_controls()) {
            if (&other != &control) {
                expect_near(other.get(scene.lights[0]), other.get(before[0]), 1e-4F);
            }
        }
        for (std::size_t i = 1; i < before.size(); ++i) {
            EXPECT_TRUE(scene.lights[i] == before[i]);
        }
        edit_light(scene.lights, "1." + std::string(control.name) + "=" +
                                     (components(control.kind) == 3 ? "1,1,1" : "1"));
    }
}

TEST(LightEdit, refuses_what_it_cannot_do_and_names_what_there_is) {
    const Scene scene = scene_at(*scene_named("studio"), 0);
    for (const char* text :
         {"", "key", "key.on", "=1", "key.=1", "nobody.on=1", "key.sound=1",
          "key.intensity=", "key.intensity=x", "key.intensity=1,2", "key.intensity=nan",
          "key.intensity=0", "key.intensity=inf", "key.color=1,2", "key.color=1,0.5,0.5,0.5",
          "key.color=2,0,0", "key.on=2", "key.position=1,2,1e9", "9.on=1"}) {
        std::vector<PointLight> lights = scene.lights;
        EXPECT_THROW(edit_light(lights, text), lutlib::UsageError) << text;
        EXPECT_TRUE(lights == scene.lights) << text;
    }
    std::vector<PointLight> none;
    EXPECT_THROW(edit_light(none, "0.on=1"), lutlib::UsageError);
}

} // namespace
} // namespace preview
