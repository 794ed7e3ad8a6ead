// The exterior: a terrace above hills under a clear sky, whose sun stands where --sun-height and
// --sun-azimuth put it. White walls and cloth near the sun's brightest, terracotta, leaves, skin, a
// chrome ball that shows the sky, and distance that fades into blue.
#include "preview/scene/angles.h"
#include "preview/scene/builtin.h"
#include "preview/scene/pictures.h"
#include "preview/scene/shapes.h"
#include "preview/scene/swatches.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

namespace preview {

namespace {

constexpr float wall_top = 0.62F;
constexpr float wall_z = -2.2F;
constexpr glm::vec3 leaf_green{0.045F, 0.115F, 0.022F};
constexpr glm::vec3 terracotta{0.42F, 0.145F, 0.065F};

class Terrace {
  public:
    SceneBuilder build;

    std::uint32_t paint_of(glm::vec3 albedo, float roughness, float metalness = 0) {
        return build.material({.albedo = albedo, .roughness = roughness, .metalness = metalness});
    }
    void block(std::uint32_t material, glm::vec3 low, glm::vec3 high, float radius = 0.01F) {
        build.place(build.mesh(box((high - low) / 2.0F, radius, 2)), material,
                    at((low + high) / 2.0F));
    }
    void ball(std::uint32_t material, glm::vec3 place, float radius) {
        build.place(ball_, material, at(place, glm::vec3(radius)));
    }
    void upright(std::uint32_t material, glm::vec3 foot, float radius, float height) {
        build.place(rod_, material,
                    at(foot + glm::vec3(0, height / 2, 0), {radius, height / 2, radius}));
    }

  private:
    std::uint32_t ball_ = build.mesh(sphere(24, 48));
    std::uint32_t rod_ = build.mesh(cylinder(24));
};

/// A ball of leaves: lumps of noise about the unit sphere, darker in their hollows.
Mesh foliage(std::uint32_t seed, glm::vec3 color) {
    const auto lump = [seed](glm::vec2 at) {
        return layered_noise({14 * at.x, 9 * at.y}, {14, 64}, 3, seed);
    };
    Mesh mesh = surface(40, 24, [lump](glm::vec2 at) {
        const float around = 2 * pi * at.x;
        const float down = pi * glm::clamp(at.y, 0.001F, 0.999F);
        const float radius = 0.62F + 0.62F * lump(at);
        return radius * glm::vec3(std::sin(down) * std::sin(around), std::cos(down),
                                  std::sin(down) * std::cos(around));
    });
    paint(mesh, [color](const Vertex& vertex) {
        const float out = glm::smoothstep(0.72F, 1.12F, glm::length(vertex.position));
        return color * glm::mix(0.35F, 1.5F, out);
    });
    return mesh;
}

void add_paving(Terrace& terrace) {
    SceneBuilder& build = terrace.build;
    Material stone{.albedo = {0.46F, 0.41F, 0.34F}, .roughness = 0.8F};
    stone.detail.base.texture = build.texture(plaster(), true);
    stone.detail.normal.texture = build.texture(dented_normals(), false);
    stone.detail.normal_scale = 0.35F;
    const auto slab_stone = build.material(stone);
    Mesh top = box({0.47F, 0.03F, 0.47F}, 0.012F, 1);
    top.details.assign(top.vertices.size(), {});
    for (std::size_t i = 0; i < top.vertices.size(); ++i) {
        const glm::vec3 place = top.vertices[i].position;
        top.details[i].uv[0] = 0.5F + glm::vec2(place.x, place.z);
        top.details[i].tangent = glm::vec4(1, 0, 0, 1);
    }
    const auto slab = build.mesh(std::move(top));
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 10; ++column) {
            const float shift = row % 2 == 0 ? 0.0F : 0.48F;
            const glm::vec3 place(-4.9F + 0.96F * static_cast<float>(column) + shift, -0.03F,
                                  -1.7F + 0.96F * static_cast<float>(row));
            build.place(
                slab, slab_stone,
                turned(at(place), 90.0F * static_cast<float>((row + column) % 4), {0, 1, 0}));
        }
    }
    terrace.block(terrace.paint_of({0.21F, 0.18F, 0.15F}, 0.95F), {-6, -0.6F, wall_z - 0.2F},
                  {6, -0.04F, 3}, 0);
}

void add_wall(Terrace& terrace) {
    SceneBuilder& build = terrace.build;
    Material lime{.albedo = glm::vec3(0.80F, 0.785F, 0.75F), .roughness = 0.92F};
    const auto white = build.material(lime);
    const auto coping = terrace.paint_of({0.50F, 0.43F, 0.34F}, 0.85F);
    terrace.block(white, {-1.9F, -0.2F, wall_z - 0.14F}, {5.5F, wall_top - 0.06F, wall_z + 0.14F},
                  0.03F);
    terrace.block(coping, {-1.9F, wall_top - 0.06F, wall_z - 0.19F},
                  {5.5F, wall_top, wall_z + 0.19F}, 0.02F);
}

/// Rows of half-round tiles down a slope.
Mesh tiles() {
    return two_sided(surface(180, 12, [](glm::vec2 at) {
        const float ridge = std::abs(std::sin(14 * pi * at.x));
        const float step = 0.035F * (1 - (6 * at.y - std::floor(6 * at.y)));
        return glm::vec3(3.2F * at.x, 0.85F * (1 - at.y) + 0.07F * ridge + step, 1.9F * at.y);
    }));
}

void add_house(Terrace& terrace) {
    SceneBuilder& build = terrace.build;
    Material lime{.albedo = glm::vec3(0.82F, 0.80F, 0.765F), .roughness = 0.95F};
    lime.detail.base.texture = build.texture(plaster(), true);
    const auto white = build.material(lime);
    const float z = -2.0F;
    // Its front around a door and a window, which lie deep in the wall.
    const auto wall = [&](glm::vec2 low, glm::vec2 high) {
        Mesh mesh = box({(high - low) / 2.0F, 0.15F}, 0, 1);
        mesh.details.assign(mesh.vertices.size(), {});
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            mesh.details[i].uv[0] = 0.7F * (low + glm::vec2(mesh.vertices[i].position));
        }
        build.place(build.mesh(std::move(mesh)), white, at({(low + high) / 2.0F, z - 0.15F}));
    };
    wall({-4.9F, 0}, {-3.95F, 2.64F});
    wall({-3.95F, 2.02F}, {-3.15F, 2.64F});
    wall({-3.15F, 0}, {-2.75F, 2.64F});
    wall({-2.75F, 0}, {-2.15F, 0.95F});
    wall({-2.75F, 1.85F}, {-2.15F, 2.64F});
    wall({-2.15F, 0}, {-1.75F, 2.64F});
    terrace.block(white, {-2.05F, 0, z - 4}, {-1.75F, 2.64F, z - 0.3F}, 0.004F);
    const auto dark = terrace.paint_of(glm::vec3(0.006F), 0.6F);
    terrace.block(dark, {-4.8F, 0, z - 0.6F}, {-2.1F, 2.4F, z - 0.5F}, 0);
    const auto blue = terrace.paint_of({0.035F, 0.13F, 0.33F}, 0.45F);
    terrace.block(blue, {-3.93F, 0.02F, z - 0.22F}, {-3.17F, 2.0F, z - 0.16F}, 0.01F);
    for (int i = 0; i < 3; ++i) {
        const float y = 0.2F + 0.6F * static_cast<float>(i);
        terrace.block(blue, {-3.82F, y, z - 0.17F}, {-3.28F, y + 0.48F, z - 0.14F}, 0.012F);
    }
    for (const float x : {-2.86F, -2.04F}) {
        for (int i = 0; i < 9; ++i) {
            const float y = 0.97F + 0.1F * static_cast<float>(i);
            const auto slat = build.mesh(box({0.13F, 0.045F, 0.008F}, 0.004F, 1));
            build.place(slat, blue, turned(at({x, y + 0.05F, z + 0.03F}), -24, {1, 0, 0}));
        }
    }
    terrace.block(terrace.paint_of({0.46F, 0.40F, 0.32F}, 0.85F), {-2.85F, 0.89F, z - 0.05F},
                  {-2.05F, 0.95F, z + 0.09F}, 0.012F);
    build.place(build.mesh(tiles()), terrace.paint_of(terracotta, 0.85F),
                at({-4.75F, 2.47F, z - 1.55F}));
}

void add_pots(Terrace& terrace) {
    SceneBuilder& build = terrace.build;
    constexpr glm::vec2 profile[]{{0, 0},         {0.13F, 0},      {0.13F, 0},      {0.18F, 0.24F},
                                  {0.18F, 0.24F}, {0.205F, 0.24F}, {0.205F, 0.24F}, {0.21F, 0.31F},
                                  {0.21F, 0.31F}, {0.18F, 0.31F},  {0.18F, 0.31F},  {0, 0.29F}};
    const auto pot = build.mesh(lathe(smoothed(profile, 3), 40));
    const auto clay = terrace.paint_of(terracotta, 0.8F);
    const auto bush = build.mesh(foliage(7, leaf_green));
    const auto green = build.material({.albedo = glm::vec3(1), .roughness = 0.5F});
    const std::array<glm::vec3, 3> petals{
        glm::vec3(0.50F, 0.012F, 0.018F), {0.62F, 0.10F, 0.24F}, {0.72F, 0.33F, 0.02F}};
    const std::array<glm::vec3, 4> places{glm::vec3(-1.45F, 0, wall_z + 0.55F),
                                          {1.55F, wall_top, wall_z},
                                          {3.0F, wall_top, wall_z},
                                          {-3.0F, 0, wall_z + 0.5F}};
    for (std::size_t p = 0; p < places.size(); ++p) {
        build.place(pot, clay, at(places[p]));
        const glm::vec3 middle = places[p] + glm::vec3(0, 0.46F, 0);
        build.place(bush, green,
                    turned(at(middle), 80 * static_cast<float>(p), {0, 1, 0}) *
                        at({0, 0, 0}, {0.27F, 0.22F, 0.27F}));
        const auto petal = terrace.paint_of(petals[p % petals.size()], 0.6F);
        for (int i = 0; i < 11; ++i) {
            const auto n = static_cast<float>(i);
            const float around = glm::radians(137.508F * n);
            const float tilt = 0.25F + 0.09F * n;
            const glm::vec3 out(std::sin(tilt) * std::sin(around), std::cos(tilt),
                                std::sin(tilt) * std::cos(around));
            terrace.ball(petal, middle + out * glm::vec3(0.28F, 0.23F, 0.28F), 0.034F);
        }
    }
}

void add_things(Terrace& terrace) {
    SceneBuilder& build = terrace.build;
    // Skins from light to dark on the wall, and beside them what shows the sky.
    const std::array<glm::vec3, 5> skins{linear_of_lab({70.0F, 9.5F, 14.5F}),
                                         linear_of(measured_skins[6]), linear_of(measured_skins[2]),
                                         linear_of(color_checker[0]), linear_of(skin_tones[8])};
    for (std::size_t i = 0; i < skins.size(); ++i) {
        terrace.ball(terrace.paint_of(skins[i], 0.42F),
                     {-0.9F + 0.34F * static_cast<float>(i), wall_top + 0.13F, wall_z + 0.02F},
                     0.13F);
    }
    terrace.ball(terrace.paint_of(glm::vec3(0.9F), 0.04F, 1), {0.95F, wall_top + 0.17F, wall_z},
                 0.17F);
    // A table with a white cloth, a bowl of lemons, a blue glass.
    const glm::vec3 middle(1.75F, 0.66F, -0.85F);
    Material linen{.albedo = {0.86F, 0.85F, 0.82F}, .roughness = 0.95F};
    linen.detail.normal.texture = build.texture(weave_normals(), false);
    Mesh cloth = surface(72, 24, [](glm::vec2 at) {
        const float around = 2 * pi * at.x;
        const float out = 1.32F * at.y;
        const float hang = std::max(out - 0.78F, 0.0F);
        const float fold = 1 + 0.16F * hang * std::sin(9 * around) + 0.05F * hang;
        const float radius = std::min(out, 0.78F) * fold + 0.12F * hang;
        return glm::vec3(radius * std::sin(around), -0.95F * hang, radius * std::cos(around));
    });
    repeat(cloth, {18, 6});
    build.place(build.mesh(two_sided(std::move(cloth))), build.material(linen),
                at(middle, {0.82F, 1, 0.82F}));
    terrace.upright(terrace.paint_of(glm::vec3(0.05F), 0.5F), {middle.x, 0, middle.z}, 0.04F,
                    0.66F);
    constexpr glm::vec2 bowl[]{{0, 0},        {0.09F, 0},      {0.09F, 0},      {0.17F, 0.05F},
                               {0.23F, 0.1F}, {0.225F, 0.11F}, {0.16F, 0.065F}, {0, 0.03F}};
    build.place(build.mesh(lathe(smoothed(bowl, 4), 48)),
                terrace.paint_of({0.05F, 0.17F, 0.30F}, 0.15F), at(middle));
    const auto lemon = terrace.paint_of({0.80F, 0.56F, 0.03F}, 0.4F);
    for (int i = 0; i < 5; ++i) {
        const float around = 1.26F * static_cast<float>(i);
        terrace.ball(lemon,
                     middle + glm::vec3(0.1F * std::sin(around), 0.115F, 0.1F * std::cos(around)),
                     0.064F);
    }
    terrace.ball(lemon, middle + glm::vec3(0, 0.19F, 0), 0.062F);
    terrace.upright(terrace.paint_of({0.01F, 0.03F, 0.16F}, 0.06F),
                    middle + glm::vec3(-0.33F, 0, 0.2F), 0.045F, 0.2F);
    // A parasol in red and white, which throws the terrace's one large shadow.
    Mesh canopy = surface(96, 8, [](glm::vec2 at) {
        const float around = 2 * pi * at.x;
        const float sag = 1 - 0.045F * at.y * std::abs(std::sin(4 * around));
        return glm::vec3(1.25F * at.y * sag * std::sin(around), 0.42F * (1 - at.y * at.y),
                         1.25F * at.y * sag * std::cos(around));
    });
    for (VertexDetail& detail : canopy.details) {
        const bool is_red = static_cast<int>(std::floor(16 * detail.uv[0].x)) % 2 == 0;
        detail.color =
            is_red ? glm::vec4(0.52F, 0.03F, 0.025F, 1) : glm::vec4(0.82F, 0.8F, 0.74F, 1);
    }
    const glm::vec3 foot(2.7F, 0, -1.35F);
    build.place(build.mesh(two_sided(std::move(canopy))),
                build.material({.albedo = glm::vec3(1), .roughness = 0.9F}),
                turned(at(foot + glm::vec3(0, 1.9F, 0)), 7, {0, 0, 1}));
    terrace.upright(terrace.paint_of({0.32F, 0.2F, 0.1F}, 0.6F), foot, 0.025F, 2.3F);
}

float hill_height(glm::vec2 place) {
    const float away = std::max(-place.y - 6, 0.0F);
    const float large = layered_noise(place / 26.0F + 40.0F, {128, 128}, 4, 21);
    const float ramp = glm::smoothstep(0.0F, 90.0F, away);
    return -4.5F - 3 * glm::smoothstep(0.0F, 20.0F, away) + 4 * large +
           ramp * (17 * large * large + 3);
}

/// What the air adds to a surface so far away.
glm::vec3 with_distance(glm::vec3 albedo, float away) {
    return glm::mix(glm::vec3(0.33F, 0.42F, 0.56F), albedo, std::exp(-away / 190));
}

void add_land(Terrace& terrace) {
    SceneBuilder& build = terrace.build;
    Mesh land = surface(140, 90, [](glm::vec2 at) {
        const float away = 4 + 146 * (1 - at.y) * (1 - at.y);
        const float x = (at.x - 0.5F) * (30 + 1.7F * away);
        return glm::vec3(x, hill_height({x, -away}), -away);
    });
    paint(land, [](const Vertex& vertex) {
        const glm::vec2 place(vertex.position.x, vertex.position.z);
        const float field = layered_noise(place / 9.0F + 60.0F, {64, 64}, 2, 33);
        const float wood = layered_noise(place / 5.0F + 20.0F, {64, 64}, 3, 57);
        glm::vec3 color =
            glm::mix(glm::vec3(0.115F, 0.17F, 0.035F), glm::vec3(0.36F, 0.27F, 0.075F),
                     glm::smoothstep(0.42F, 0.56F, field));
        color =
            glm::mix(color, glm::vec3(0.03F, 0.062F, 0.018F), glm::smoothstep(0.52F, 0.58F, wood));
        return with_distance(color, -vertex.position.z);
    });
    build.place(build.mesh(std::move(land)),
                build.material({.albedo = glm::vec3(1), .roughness = 1}), glm::mat4(1), false);
    constexpr glm::vec2 cypress[]{{0, 0},        {0.26F, 0},     {0.34F, 0.2F}, {0.36F, 0.5F},
                                  {0.3F, 0.72F}, {0.16F, 0.92F}, {0, 1}};
    Mesh shape = lathe(smoothed(cypress, 5), 28);
    for (Vertex& vertex : shape.vertices) {
        const float turn = std::atan2(vertex.position.z, vertex.position.x) / (2 * pi) + 0.5F;
        const float lump = layered_noise({12 * turn, 16 * vertex.position.y}, {12, 64}, 2, 3);
        vertex.position.x *= 0.75F + 0.5F * lump;
        vertex.position.z *= 0.75F + 0.5F * lump;
        vertex.normal = glm::normalize(vertex.normal + glm::vec3(0, 1.2F * (lump - 0.5F), 0));
    }
    const auto tree = build.mesh(std::move(shape));
    constexpr std::array<glm::vec3, 11> trees{glm::vec3(-0.6F, -9, 3.1F),
                                              {0.5F, -10, 3.6F},
                                              {1.7F, -11.5F, 3.3F},
                                              {5.6F, -9, 4.2F},
                                              {-7, -26, 6},
                                              {-4.6F, -27, 5},
                                              {9, -30, 6.5F},
                                              {12.5F, -33, 6},
                                              {3, -48, 7},
                                              {5, -49, 6},
                                              {-20, -52, 7}};
    for (const glm::vec3 t : trees) {
        build.place(
            tree, terrace.paint_of(with_distance({0.022F, 0.05F, 0.016F}, -t.y), 0.9F),
            at({t.x, hill_height({t.x, t.y}) - 0.22F * t.z, t.y}, {0.3F * t.z, t.z, 0.3F * t.z}),
            false);
    }
}

} // namespace

Scene exterior_scene() {
    Terrace terrace;
    add_things(terrace);
    add_pots(terrace);
    add_wall(terrace);
    add_house(terrace);
    add_paving(terrace);
    add_land(terrace);
    Scene& scene = terrace.build.scene;
    scene.surroundings.kind = SurroundingsKind::sky;
    scene.surroundings.sky = {.sun_height = 34, .sun_azimuth = 122, .turbidity = 2};
    scene.exposure = 0.5F;
    scene.occlusion = 1;
    scene.orbit = {{0.1F, 0.95F, -2.0F}, 5.2F, 4, 5, 42, 0.1F};
    return std::move(scene);
}

} // namespace preview
