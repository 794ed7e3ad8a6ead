// The chart: light of exactly known values, whatever the surroundings. From above a wedge of stops
// about 18 % grey; the ColorChecker, sweeps of hue, ramps and a zone plate; measured skins; the
// Monk Skin Tone Scale.
#include "preview/scene/builtin.h"
#include "preview/scene/pictures.h"
#include "preview/scene/swatches.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

/// Of the width, 16 units at z = 0.
constexpr float left = -7.65F;
constexpr float right = 7.65F;

/// A rectangle from -1 to 1 that faces the camera, with what `color_at` gives along it, linear.
template <class Color>
Mesh strip(int columns, Color color_at) {
    Mesh mesh;
    mesh.name = "strip";
    for (int i = 0; i <= columns; ++i) {
        const float t = static_cast<float>(i) / static_cast<float>(columns);
        for (const float y : {-1.0F, 1.0F}) {
            mesh.vertices.push_back({{2 * t - 1, y, 0}, {0, 0, 1}});
            VertexDetail detail;
            detail.uv[0] = {t, 0.5F - 0.5F * y};
            detail.color = glm::vec4(color_at(t), 1);
            mesh.details.push_back(detail);
        }
    }
    for (std::uint32_t at = 0; at < 2 * static_cast<std::uint32_t>(columns); at += 2) {
        for (const std::uint32_t corner : {0U, 2U, 3U, 0U, 3U, 1U}) {
            mesh.indices.push_back(at + corner);
        }
    }
    return mesh;
}

class Chart {
  public:
    SceneBuilder build;

    Chart() {
        tile_ = build.mesh(strip(1, [](float) { return glm::vec3(1); }));
        Material unlit{.albedo = glm::vec3(1), .roughness = 1};
        unlit.detail.is_unlit = true;
        colored_ = build.material(unlit);
    }

    /// Fills the rectangle with light.
    void patch(glm::vec2 low, glm::vec2 high, glm::vec3 light) {
        const Material glow{.albedo = glm::vec3(0), .roughness = 1, .emission = light};
        build.place(tile_, build.material(glow), over(low, high), false);
    }
    template <class Color>
    void sweep(glm::vec2 low, glm::vec2 high, int columns, Color color_at) {
        build.place(build.mesh(strip(columns, color_at)), colored_, over(low, high), false);
    }
    void picture(glm::vec2 low, glm::vec2 high, Picture shown) {
        Material paint = build.scene.materials[colored_];
        paint.detail.base.texture = build.texture(std::move(shown), true, Wrap::clamp);
        build.place(tile_, build.material(paint), over(low, high), false);
    }
    /// Patches side by side from the left edge to the right.
    template <class Rows>
    void row(float low, float high, const Rows& swatches) {
        const float step = (right - left) / static_cast<float>(swatches.size());
        for (std::size_t i = 0; i < swatches.size(); ++i) {
            const float x = left + step * static_cast<float>(i);
            patch({x, low}, {x + step, high}, linear_of(swatches[i]));
        }
    }

  private:
    static glm::mat4 over(glm::vec2 low, glm::vec2 high) {
        const glm::vec2 middle = (low + high) / 2.0F;
        const glm::vec2 half = (high - low) / 2.0F;
        return at({middle, 0}, {half, 1});
    }

    std::uint32_t tile_ = 0;
    std::uint32_t colored_ = 0;
};

void add_wedge(Chart& chart) {
    constexpr int stops = 8;
    constexpr float step = (right - left) / (2 * stops + 1);
    for (int stop = -stops; stop <= stops; ++stop) {
        const float x = left + step * static_cast<float>(stop + stops);
        chart.patch({x, 3.3F}, {x + step, 4.2F},
                    glm::vec3(0.18F * std::exp2(static_cast<float>(stop))));
    }
}

void add_color_checker(Chart& chart) {
    constexpr float pitch = 0.96F;
    for (std::size_t i = 0; i < color_checker.size(); ++i) {
        const glm::vec2 low(left + pitch * static_cast<float>(i % 6),
                            2.1F - pitch * static_cast<float>(i / 6));
        chart.patch(low, low + pitch - 0.06F, linear_of(color_checker[i]));
    }
}

/// A colour of the hue circle of HSV at the value 1, in sRGB codes, as light.
glm::vec3 hue_light(float turn, float saturation) {
    glm::vec3 light;
    for (int c = 0; c < 3; ++c) {
        const float away = std::abs(std::remainder(6 * turn - 2 * static_cast<float>(c), 6.0F));
        const float pure = std::clamp(2 - away, 0.0F, 1.0F);
        light[c] = linear_of_code(1 - saturation * (1 - pure));
    }
    return light;
}

void add_sweeps(Chart& chart) {
    constexpr float low = -1.5F;
    constexpr float high = 4.1F;
    float y = 3.0F;
    const auto next = [&](float height, auto color_at) {
        chart.sweep({low, y - height}, {high, y}, 240, color_at);
        y -= height;
    };
    for (const float saturation : {1.0F, 2 / 3.0F, 1 / 3.0F}) {
        next(0.5F, [=](float t) { return hue_light(t, saturation); });
    }
    y -= 0.12F;
    next(0.44F, [](float t) { return glm::vec3(linear_of_code(t)); });
    next(0.44F, [](float t) { return glm::vec3(t); });
    for (int c = 0; c < 3; ++c) {
        next(0.44F, [c](float t) {
            glm::vec3 light(0);
            light[c] = linear_of_code(t);
            return light;
        });
    }
}

} // namespace

Scene chart_scene() {
    Chart chart;
    add_wedge(chart);
    add_color_checker(chart);
    add_sweeps(chart);
    chart.picture({right - 3.3F, -0.3F}, {right, 3.0F}, zone_plate(512, 64));
    chart.row(-2.5F, -1.3F, measured_skins);
    chart.row(-4.0F, -2.8F, skin_tones);
    // Between two patches of the wedge, and darker than any other patch.
    chart.patch({-30, -30}, {30, 30}, glm::vec3(0.009F));
    chart.build.scene.objects.back().transform *= at({0, 0, -0.05F});
    chart.build.scene.orbit = {{0, 0, 0}, 16.794F, 0, 0, 30, 0.1F};
    return std::move(chart.build.scene);
}

} // namespace preview
