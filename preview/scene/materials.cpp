// Balls of what surfaces are made of. Rows from above: paint from polished to rough; the same paint
// from no metal to metal; metals as measured; surfaces with textures.
#include "preview/scene/builtin.h"
#include "preview/scene/pictures.h"
#include "preview/scene/shapes.h"
#include "preview/scene/swatches.h"

#include <array>
#include <cmath>
#include <numbers>

namespace preview {

namespace {

constexpr int columns = 7;

/// Reflectance at normal incidence, linear: Akenine-Moeller et al. 2018, "Real-time rendering", 4th
/// edition, table 9.2.
constexpr std::array<glm::vec3, columns> metals{{
    {0.972F, 0.960F, 0.915F}, // silver
    {0.913F, 0.922F, 0.924F}, // aluminium
    {1.000F, 0.782F, 0.344F}, // gold
    {0.910F, 0.778F, 0.423F}, // brass
    {0.955F, 0.638F, 0.538F}, // copper
    {0.562F, 0.565F, 0.578F}, // iron
    {0.542F, 0.497F, 0.449F}, // titanium
}};

Mesh ball() {
    std::vector<glm::vec2> profile;
    constexpr int steps = 32;
    for (int i = 0; i <= steps; ++i) {
        const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / steps;
        profile.push_back({std::sin(angle), -std::cos(angle)});
    }
    Mesh mesh = lathe(profile, 64);
    repeat(mesh, {2, 1});
    return mesh;
}

class Shelf {
  public:
    SceneBuilder build;

    void add(int row, int column, const Material& material) {
        const glm::vec3 place(static_cast<float>(column) - 0.5F * (columns - 1),
                              1.5F - static_cast<float>(row), 0);
        build.place(ball_, build.material(material), at(place, glm::vec3(0.44F)));
    }
    TextureUse picture(const Picture& shown, bool is_color) {
        return {.texture = build.texture(shown, is_color)};
    }

  private:
    std::uint32_t ball_ = build.mesh(ball());
};

void add_textured(Shelf& shelf) {
    const TextureUse weave = shelf.picture(weave_shades(), true);
    const TextureUse weave_bumps = shelf.picture(weave_normals(), false);
    const TextureUse wood = shelf.picture(boards(), true);
    const TextureUse wood_surface = shelf.picture(board_surface(), false);
    const TextureUse scratches = shelf.picture(brushed_normals(), false);
    const TextureUse dents = shelf.picture(dented_normals(), false);
    const TextureUse clouds = shelf.picture(plaster(), true);
    const auto add = [&](int column, glm::vec3 albedo, float roughness, float metalness,
                         const MaterialDetail& detail) {
        shelf.add(
            3, column,
            {.albedo = albedo, .roughness = roughness, .metalness = metalness, .detail = detail});
    };
    add(0, glm::vec3(1), 0.6F, 0, {.base = wood, .surface = wood_surface});
    add(1, {0.78F, 0.74F, 0.66F}, 0.95F, 0, {.base = weave, .normal = weave_bumps});
    add(2, {0.05F, 0.10F, 0.32F}, 0.9F, 0, {.base = weave, .normal = weave_bumps});
    add(3, metals[1], 0.3F, 1, {.normal = scratches});
    add(4, linear_of(color_checker[6]), 0.42F, 0, {.normal = dents});
    add(5, {0.45F, 0.40F, 0.35F}, 0.95F, 0, {.base = clouds});
    add(6, linear_of(measured_skins[5]), 0.48F, 0, {.normal = dents, .normal_scale = 0.3F});
}

} // namespace

Scene materials_scene() {
    Shelf shelf;
    const glm::vec3 paint = linear_of(color_checker[14]);
    for (int column = 0; column < columns; ++column) {
        const float t = static_cast<float>(column) / (columns - 1);
        shelf.add(0, column, {.albedo = paint, .roughness = t});
        shelf.add(1, column, {.albedo = {0.8F, 0.45F, 0.25F}, .roughness = 0.3F, .metalness = t});
        shelf.add(2, column,
                  {.albedo = metals[static_cast<std::size_t>(column)],
                   .roughness = 0.08F + 0.08F * static_cast<float>(column % 3),
                   .metalness = 1});
    }
    add_textured(shelf);
    SceneBuilder& build = shelf.build;
    build.light({{-4, 5, 6}, {130, 125, 115}, true, {0, 0, 0}, 60, 1, 16, "key"});
    build.light({{5, -1, 5}, {14, 16, 22}, false, {}, 60, 0.1F, 20, "fill"});
    build.scene.environment.zenith = {0.52F, 0.55F, 0.62F};
    build.scene.environment.horizon = {0.13F, 0.13F, 0.14F};
    build.scene.environment.ground = {0.04F, 0.035F, 0.03F};
    build.soft_box({-0.5F, 0.6F, 0.6F}, 60, {3.2F, 3.1F, 2.8F});
    build.soft_box({0.8F, 0.1F, 0.5F}, 90, {1.2F, 1.5F, 2.1F});
    build.soft_box({-0.9F, -0.1F, -0.3F}, 30, {1.1F, 1.0F, 0.85F});
    build.soft_box({0.2F, -0.9F, 0.4F}, 12, {0.14F, 0.12F, 0.10F});
    build.scene.orbit = {{0, 0, 0}, 9.6F, 0, 0, 27, 0.1F};
    return std::move(build.scene);
}

} // namespace preview
