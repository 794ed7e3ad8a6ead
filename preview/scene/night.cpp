// The night: a wet street corner under a sodium lamp, a lit shop window and neon of nearly one
// primary each, brighter than any display: colours that leave sRGB's cube by its sides. Most of the
// picture lies in deep shadow.
#include "preview/scene/builtin.h"
#include "preview/scene/pictures.h"
#include "preview/scene/shapes.h"
#include "preview/scene/swatches.h"

#include <array>
#include <cmath>

namespace preview {

namespace {

constexpr glm::vec3 wall_middle{2.1F, 2.4F, -3.0F};
constexpr glm::vec3 lamp_place{-1.55F, 3.05F, -1.5F};

constexpr glm::vec3 neon_red{11, 0.06F, 0.03F};
constexpr glm::vec3 neon_blue{0.05F, 0.22F, 17};
constexpr glm::vec3 neon_magenta{8, 0.05F, 6.5F};
constexpr glm::vec3 shop_light{2.6F, 1.35F, 0.5F};

class Street {
  public:
    SceneBuilder build;

    std::uint32_t glow(glm::vec3 light) {
        return build.material({.albedo = glm::vec3(0), .roughness = 1, .emission = light});
    }
    std::uint32_t dull(glm::vec3 albedo, float roughness, float metalness = 0) {
        return build.material({.albedo = albedo, .roughness = roughness, .metalness = metalness});
    }
    void block(std::uint32_t material, glm::vec3 low, glm::vec3 high, float radius = 0.01F,
               bool casts_shadow = true) {
        const auto mesh = build.mesh(box((high - low) / 2.0F, radius, 2));
        build.place(mesh, material, at((low + high) / 2.0F), casts_shadow);
    }
    void upright(std::uint32_t material, glm::vec3 foot, float radius, float height) {
        build.place(rod_, material,
                    at(foot + glm::vec3(0, height / 2, 0), {radius, height / 2, radius}));
    }
    void ball(std::uint32_t material, glm::vec3 place, float radius, bool casts_shadow = true) {
        build.place(ball_, material, at(place, glm::vec3(radius)), casts_shadow);
    }

  private:
    std::uint32_t rod_ = build.mesh(cylinder(24));
    std::uint32_t ball_ = build.mesh(sphere(16, 32));
};

void add_street(Street& street) {
    SceneBuilder& build = street.build;
    Material asphalt{.albedo = glm::vec3(0.022F), .roughness = 0.26F};
    asphalt.detail.normal.texture = build.texture(dented_normals(), false);
    asphalt.detail.normal_scale = 0.55F;
    Mesh ground = surface(
        12, 12, [](glm::vec2 at) { return glm::vec3(16 * (at.x - 0.5F), 0, 15.5F * at.y - 13); });
    repeat(ground, {12, 14});
    build.place(build.mesh(std::move(ground)), build.material(asphalt), glm::mat4(1), false);
    street.block(street.dull({0.05F, 0.048F, 0.046F}, 0.5F), {-0.6F, 0, -3}, {7, 0.12F, -2.2F},
                 0.03F);
    Material plaster_paint{.albedo = {0.16F, 0.115F, 0.095F}, .roughness = 0.85F};
    plaster_paint.detail.base.texture = build.texture(plaster(), true);
    Mesh wall = surface(
        1, 1, [](glm::vec2 at) { return glm::vec3(-0.6F + 7.6F * at.x, 6 - 6 * at.y, -3); });
    repeat(wall, {4, 3});
    build.place(build.mesh(std::move(wall)), build.material(plaster_paint), glm::mat4(1), false);
    street.block(street.dull({0.05F, 0.045F, 0.05F}, 0.8F), {-0.64F, 0, -9}, {-0.6F, 6, -3}, 0);
}

void add_shop(Street& street) {
    const auto frame = street.dull({0.03F, 0.045F, 0.04F}, 0.35F);
    const float z = wall_middle.z;
    street.block(street.glow(shop_light), {0.0F, 0.75F, z - 0.1F}, {1.6F, 1.85F, z + 0.01F}, 0,
                 false);
    for (const float x : {-0.04F, 0.5F, 1.06F, 1.6F}) {
        street.block(frame, {x, 0.7F, z}, {x + 0.05F, 1.9F, z + 0.06F});
    }
    for (const float y : {0.68F, 1.86F}) {
        street.block(frame, {-0.06F, y, z}, {1.68F, y + 0.06F, z + 0.08F});
    }
    // Silhouettes on the sill.
    const auto black = street.dull(glm::vec3(0.01F), 0.3F);
    for (int i = 0; i < 6; ++i) {
        const float x = 0.16F + 0.26F * static_cast<float>(i);
        street.upright(black, {x, 0.74F, z + 0.06F}, 0.045F,
                       0.24F + 0.13F * std::abs(std::sin(3.1F * static_cast<float>(i))));
    }
    // An awning of red cloth.
    const auto mesh = street.build.mesh(box({0.95F, 0.012F, 0.36F}, 0.01F, 1));
    street.build.place(mesh, street.dull({0.30F, 0.02F, 0.025F}, 0.8F),
                       turned(at({0.8F, 2.08F, z + 0.34F}), 24, {1, 0, 0}));
}

void add_neon(Street& street) {
    SceneBuilder& build = street.build;
    const float z = wall_middle.z + 0.1F;
    const auto ring = build.mesh(torus(0.035F, 96, 12));
    const auto place_ring = [&](glm::vec3 light, glm::vec3 middle, float radius) {
        build.place(ring, street.glow(light),
                    turned(at(middle), 90, {1, 0, 0}) * at({0, 0, 0}, glm::vec3(radius)), false);
    };
    place_ring(neon_blue, {2.75F, 2.45F, z}, 0.62F);
    place_ring(neon_red, {2.75F, 2.45F, z}, 0.40F);
    const auto tube = build.mesh(box({0.34F, 0.018F, 0.018F}, 0.018F, 3));
    const auto magenta = street.glow(neon_magenta);
    for (int i = 0; i < 4; ++i) {
        const float x = 0.05F + 0.48F * static_cast<float>(i);
        build.place(tube, magenta,
                    turned(at({x, 2.75F, z}), i % 2 == 0 ? 45.0F : -45.0F, {0, 0, 1}), false);
    }
}

void add_lamp(Street& street) {
    const auto iron = street.dull({0.02F, 0.022F, 0.025F}, 0.4F, 0.6F);
    const glm::vec3 p = lamp_place;
    street.upright(iron, {p.x - 0.55F, 0, p.z}, 0.045F, 3.25F);
    street.block(iron, {p.x - 0.58F, p.y + 0.16F, p.z - 0.02F},
                 {p.x + 0.1F, p.y + 0.2F, p.z + 0.02F});
    street.block(iron, {p.x - 0.16F, p.y + 0.08F, p.z - 0.12F},
                 {p.x + 0.16F, p.y + 0.16F, p.z + 0.12F}, 0.03F, false);
    street.ball(street.glow({80, 38, 7.5F}), p, 0.075F, false);
    // A signal at red, and lights of the town far behind.
    street.block(iron, {-2.42F, 2.0F, -1.62F}, {-2.2F, 2.62F, -1.42F}, 0.03F);
    street.ball(street.glow({30, 0.3F, 0.1F}), {-2.31F, 2.5F, -1.4F}, 0.06F, false);
    street.ball(street.dull({0.05F, 0.03F, 0.0F}, 0.3F), {-2.31F, 2.31F, -1.4F}, 0.06F, false);
    street.ball(street.dull({0.0F, 0.04F, 0.015F}, 0.3F), {-2.31F, 2.12F, -1.4F}, 0.06F, false);
    constexpr std::array<glm::vec3, 5> far_lights{
        glm::vec3(9, 4.4F, 1.2F), {4, 5, 6}, {8, 0.4F, 0.2F}, {0.4F, 5, 3}, {9, 6, 3}};
    for (int i = 0; i < 22; ++i) {
        const auto n = static_cast<float>(i);
        const float depth = 10 + 8 * value_noise({n * 1.7F, 3}, {64, 64}, 5);
        street.ball(street.glow(far_lights[static_cast<std::size_t>(i) % far_lights.size()]),
                    {-7.2F + 6 * value_noise({n * 2.3F, 1}, {64, 64}, 6),
                     0.3F + 2.6F * value_noise({n * 3.1F, 2}, {64, 64}, 7), -depth},
                    0.05F, false);
    }
}

void add_things(Street& street) {
    SceneBuilder& build = street.build;
    const auto crate = build.mesh(box({0.32F, 0.28F, 0.28F}, 0.012F, 1));
    const auto crate_paint = street.dull({0.22F, 0.13F, 0.065F}, 0.75F);
    build.place(crate, crate_paint, turned(at({2.75F, 0.40F, -2.35F}), 8, {0, 1, 0}));
    build.place(crate, crate_paint, turned(at({2.05F, 0.28F, -1.75F}), -22, {0, 1, 0}));
    build.place(crate, crate_paint, turned(at({2.7F, 0.96F, -2.4F}), -12, {0, 1, 0}));
    const auto steel = street.dull({0.55F, 0.55F, 0.56F}, 0.32F, 1);
    street.upright(steel, {3.45F, 0.12F, -2.5F}, 0.27F, 0.85F);
    // Skins on a bench under the lamp.
    const auto bench = street.dull({0.10F, 0.06F, 0.035F}, 0.5F);
    street.block(bench, {-1.35F, 0.40F, -1.35F}, {0.75F, 0.46F, -0.95F}, 0.02F);
    for (const float x : {-1.15F, 0.55F}) {
        street.block(bench, {x - 0.04F, 0, -1.3F}, {x + 0.04F, 0.4F, -1.0F}, 0.01F);
    }
    const std::array<glm::vec3, 4> skins{linear_of(measured_skins[11]),
                                         linear_of(measured_skins[2]), linear_of(color_checker[0]),
                                         linear_of(skin_tones[8])};
    for (std::size_t i = 0; i < skins.size(); ++i) {
        street.ball(street.dull(skins[i], 0.45F),
                    {-1.05F + 0.46F * static_cast<float>(i), 0.62F, -1.15F}, 0.16F);
    }
    const auto white = street.dull(glm::vec3(0.75F), 0.5F);
    const auto red = street.dull(linear_of(color_checker[14]), 0.5F);
    for (const float x : {1.0F, 1.75F, 2.5F}) {
        street.upright(white, {x, 0, -0.35F}, 0.06F, 0.62F);
        street.upright(red, {x, 0.42F, -0.35F}, 0.063F, 0.1F);
    }
}

} // namespace

Scene night_scene() {
    Street street;
    add_things(street);
    add_lamp(street);
    add_shop(street);
    add_neon(street);
    add_street(street);
    SceneBuilder& build = street.build;
    build.light({lamp_place, {10, 4.9F, 1.1F}, true, {-1.0F, 0, -1.2F}, 130, 0.2F, 12, "lamp"});
    build.light(
        {{0.8F, 1.4F, -2.3F}, {2.6F, 1.4F, 0.55F}, true, {0.8F, 0.3F, 0}, 140, 0.1F, 10, "shop"});
    build.light({{2.75F, 2.45F, -2.45F}, {0.03F, 0.08F, 3.6F}, false, {}, 60, 0.1F, 20, "blue"});
    build.light({{2.75F, 2.3F, -2.5F}, {1.9F, 0.02F, 0.01F}, false, {}, 60, 0.1F, 20, "red"});
    build.light({{0.75F, 2.75F, -2.5F}, {1.3F, 0.01F, 1.05F}, false, {}, 60, 0.1F, 20, "magenta"});
    build.scene.environment.zenith = {0.0022F, 0.0032F, 0.0065F};
    build.scene.environment.horizon = {0.0060F, 0.0052F, 0.0056F};
    build.scene.environment.ground = {0.0010F, 0.0010F, 0.0011F};
    build.scene.orbit = {{0.55F, 1.35F, -1.6F}, 6.4F, -4, 5, 36, 0.1F};
    return std::move(build.scene);
}

} // namespace preview
