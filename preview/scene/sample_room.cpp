// The sample's room: plastered walls, a window with bars, a table of boards, a cloth on it.
#include "preview/scene/pictures.h"
#include "preview/scene/sample_parts.h"
#include "preview/scene/shapes.h"
#include "preview/scene/swatches.h"

#include <glm/common.hpp>

#include <cmath>

namespace preview {

namespace {

/// A flat rectangle from `corner` along two edges; its picture is repeated so often.
Mesh sheet(glm::vec3 corner, glm::vec3 along, glm::vec3 down, glm::vec2 times) {
    Mesh mesh = surface(1, 1, [=](glm::vec2 at) { return corner + at.x * along + at.y * down; });
    repeat(mesh, times);
    return mesh;
}

void add_box(SceneBuilder& build, std::uint32_t material, glm::vec3 low, glm::vec3 high,
             float radius) {
    const auto mesh = build.mesh(box((high - low) / 2.0F, radius, 2));
    build.place(mesh, material, at((low + high) / 2.0F));
}

void add_walls(SceneBuilder& build) {
    const WindowFrame& w = sample_window;
    const auto wall = build.material({.albedo = {0.275F, 0.305F, 0.295F}, .roughness = 0.95F});
    build.place(build.mesh(sheet({-4, 4, -1.5F}, {8, 0, 0}, {0, -6, 0}, {5, 4})), wall,
                glm::mat4(1), false);
    // Around the opening, so wide that nothing of the sun passes beside it.
    constexpr float reach = 3;
    constexpr float depth = 0.16F;
    const float x = w.plane;
    const auto side = [&](float low_y, float high_y, float low_z, float high_z) {
        add_box(build, wall, {x - depth, low_y, low_z}, {x, high_y, high_z}, 0);
    };
    side(w.high_y, w.high_y + reach, -reach, reach);
    side(-1, w.low_y, -reach, reach);
    side(w.low_y, w.high_y, -reach, w.low_z);
    side(w.low_y, w.high_y, w.high_z, reach);
}

void add_window(SceneBuilder& build) {
    const WindowFrame& w = sample_window;
    const auto wood = build.material({.albedo = {0.62F, 0.60F, 0.55F}, .roughness = 0.4F});
    const float x = w.plane;
    const auto bar = [&](float y, float z, float half_y, float half_z, float half_x) {
        add_box(build, wood, {x - 0.08F - half_x, y - half_y, z - half_z},
                {x - 0.08F + half_x, y + half_y, z + half_z}, 0.006F);
    };
    const glm::vec3 c = w.middle();
    const float tall = (w.high_y - w.low_y) / 2;
    const float wide = (w.high_z - w.low_z) / 2;
    for (const float end : {-1.0F, 1.0F}) {
        bar(c.y + end * tall, c.z, 0.045F, wide, 0.05F);
        bar(c.y, c.z + end * wide, tall, 0.045F, 0.05F);
    }
    for (const float third : {-1.0F, 1.0F}) {
        bar(c.y, c.z + third * wide / 3, tall, 0.03F, 0.03F);
    }
    for (const float third : {-1.0F, 1.0F}) {
        bar(c.y + third * tall / 3, c.z, 0.018F, wide, 0.022F);
    }
    add_box(build, wood, {x - 0.1F, w.low_y - 0.05F, w.low_z - 0.1F},
            {x + 0.1F, w.low_y, w.high_z + 0.1F}, 0.012F);
    // What is seen of the bright garden.
    Material sky{.albedo = glm::vec3(0), .roughness = 1, .emission = {13, 15, 18}};
    sky.detail.emission.texture = build.texture(garden(), true, Wrap::clamp);
    build.place(build.mesh(sheet({x - 0.5F, 3.2F, 2.5F}, {0, 0, -5}, {0, -3.6F, 0}, {1, 1})),
                build.material(sky), glm::mat4(1), false);
}

void add_table(SceneBuilder& build) {
    Material wood{.albedo = glm::vec3(1), .roughness = 0.45F};
    wood.detail.base.texture = build.texture(boards(), true);
    build.place(build.mesh(sheet({-1.74F, 0, -1.49F}, {5.2F, 0, 0}, {0, 0, 3.6F}, {2.0F, 2.6F})),
                build.material(wood), glm::mat4(1), false);
}

/// A cloth of 1 x 1 laid down without care: where it lies at `at`, and how high.
glm::vec3 cloth_at(glm::vec2 at) {
    const glm::vec2 p = at - 0.5F;
    const float folds = layered_noise({3 * at.x + 1.5F * at.y, 2 * at.y}, {64, 64}, 3, 91);
    const float long_fold = std::sin(7 * p.x + 5 * p.y + 4 * folds);
    const float rim = 2 * std::max(std::abs(p.x), std::abs(p.y));
    const float height =
        0.012F + 0.05F * std::max(long_fold, 0.0F) * (0.35F + folds) * rim + 0.02F * folds;
    return {p.x + 0.05F * (folds - 0.5F), height, p.y + 0.06F * (folds - 0.5F) + 0.05F * p.x};
}

} // namespace

void add_room(SceneBuilder& build) {
    add_walls(build);
    add_window(build);
    add_table(build);
}

void add_cloth(SceneBuilder& build) {
    Mesh mesh =
        surface(96, 72, [](glm::vec2 at) { return cloth_at(at) * glm::vec3(1.75F, 1, 1.25F); });
    // Two bands of blue along each edge.
    for (VertexDetail& detail : mesh.details) {
        const glm::vec2 edge = glm::min(detail.uv[0], 1.0F - detail.uv[0]) * glm::vec2(96, 72);
        const float inwards = std::min(edge.x, edge.y);
        const bool is_blue =
            (inwards > 5.5F && inwards < 9.5F) || (inwards > 11.5F && inwards < 13.5F);
        detail.color = is_blue ? glm::vec4(0.06F, 0.13F, 0.36F, 1) : glm::vec4(1);
    }
    repeat(mesh, {9, 7});
    Material linen{.albedo = {0.80F, 0.775F, 0.71F}, .roughness = 0.95F};
    linen.detail.base.texture = build.texture(weave_shades(), true);
    linen.detail.normal.texture = build.texture(weave_normals(), false);
    build.place(build.mesh(std::move(mesh)), build.material(linen),
                turned(at({0.12F, 0, 0.25F}), 14, {0, 1, 0}));
}

} // namespace preview
