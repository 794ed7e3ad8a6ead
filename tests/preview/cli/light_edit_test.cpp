// --light: what it sets and what it refuses.
#include "preview/cli/light_edit.h"

#include "lutlib/error.h"
#include "preview/scene/light_controls.h"
#include "preview/scene/light_data.h"
#include "preview/scene/scene.h"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cstring>

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
    for (const char* text : {"",
                             "key",
                             "key.on",
                             "=1",
                             "key.=1",
                             "nobody.on=1",
                             "key.sound=1",
                             "key.intensity=",
                             "key.intensity=x",
                             "key.intensity=1,2",
                             "key.intensity=nan",
                             "key.intensity=0",
                             "key.intensity=inf",
                             "key.color=1,2",
                             "key.color=1,0.5,0.5,0.5",
                             "key.color=2,0,0",
                             "key.color=0,0,0",
                             "key.on=2",
                             "key.position=1,2,1e9",
                             "9.on=1"}) {
        std::vector<PointLight> lights = scene.lights;
        EXPECT_THROW(edit_light(lights, text), lutlib::UsageError) << text;
        EXPECT_TRUE(lights == scene.lights) << text;
    }
    std::vector<PointLight> none;
    EXPECT_THROW(edit_light(none, "0.on=1"), lutlib::UsageError);
}

/// Balls on all sides of a light in their middle.
Scene scene_about_a_light() {
    Scene scene;
    scene.meshes.push_back(sphere(8, 16));
    scene.materials.push_back({});
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-3.0F, 3.0F}) {
            glm::vec3 place(0);
            place[axis] = side;
            Object ball;
            ball.transform = glm::translate(glm::mat4(1), place);
            scene.objects.push_back(ball);
        }
    }
    return scene;
}

/// What shaders and shadow maps get of a light.
std::vector<std::byte> seen_of(const PointLight& light, const Scene& scene, bool shadows_fall) {
    if (!light.is_on || light.intensity == glm::vec3(0)) {
        return {};
    }
    const LightShadow shadow =
        shadows_fall ? shadow_of(scene, geometry_of(scene), light, 64) : LightShadow{};
    const LightBlock block = light_block(light, shadow, shadow.views.empty() ? -1 : 0, 64);
    std::vector<std::byte> out(sizeof block);
    std::memcpy(out.data(), &block, sizeof block);
    for (const ShadowView& view : shadow.views) {
        const glm::mat4 clip = shadow_clip(light, view.frustum);
        const auto* const bytes = reinterpret_cast<const std::byte*>(&clip);
        out.insert(out.end(), bytes, bytes + sizeof clip);
    }
    return out;
}

TEST(LightControls, say_that_they_change_nothing_where_they_do) {
    const Scene scene = scene_about_a_light();
    const auto made = [](auto change) {
        PointLight light;
        light.position = {0.2F, 0.4F, 0.1F};
        light.aim = {3, 0.2F, 0.1F};
        light.intensity = {4, 2, 1};
        change(light);
        return light;
    };
    const PointLight lights[] = {
        made([](PointLight&) {}),
        made([](PointLight& l) { l.casts_shadow = true; }),
        made([](PointLight& l) {
            l.casts_shadow = true;
            l.shadow_angle = PointLight::all_round;
        }),
        made([](PointLight& l) { l.is_sun = true; }),
        made([](PointLight& l) { l.is_sun = l.casts_shadow = true; }),
        made([](PointLight& l) {
            l.outer_angle = 30;
            l.casts_shadow = true;
        }),
        made([](PointLight& l) { // a ring
            l.shape = PointLight::Shape::ring;
            l.extent = {0, 0.1F, 0};
            l.thickness = 0.01F;
        }),
        made([](PointLight& l) { l.is_on = false; }),
        made([](PointLight& l) { l.intensity = {}; }),
    };
    int idle = 0;
    for (const PointLight& light : lights) {
        for (const LightControl& control : light_controls()) {
            for (const bool shadows_fall : {true, false}) {
                PointLight changed = light;
                control.set(changed, control.kind == LightControl::Kind::flag
                                         ? glm::vec3(1 - control.get(light).x)
                                     : control.name == "angle" ? glm::vec3(100)
                                                               : glm::vec3(0.5F, 0.9F, 0.25F));
                const std::string_view why = idle_because(control, light, shadows_fall);
                EXPECT_EQ(seen_of(light, scene, shadows_fall) ==
                              seen_of(changed, scene, shadows_fall),
                          !why.empty())
                    << control.name << " of light " << &light - lights << ": " << why;
                idle += why.empty() ? 0 : 1;
            }
        }
    }
    EXPECT_GT(idle, 20);
}

} // namespace
} // namespace preview
