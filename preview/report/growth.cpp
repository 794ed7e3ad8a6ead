#include "preview/report/growth.h"

#include "preview/report/test_pictures.h"
#include "preview/scene/builtin.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace preview::report {

namespace {

Situation showing(const Situation& situation, Scene scene) {
    Situation out = situation;
    out.settings.orbit = scene.orbit;
    out.settings.effects.clear();
    out.look_a = out.look_b = nullptr;
    out.lights = scene.lights;
    out.surroundings = scene.surroundings;
    Shown shown;
    shown.name = "a scene for measuring";
    shown.scene = std::move(scene);
    out.shown = std::make_shared<const Shown>(std::move(shown));
    return out;
}

/// A floor that fills the picture.
Scene floor_scene() {
    SceneBuilder build;
    build.place(build.mesh(plane()), build.material({}), at({0, 0, 0}, {4, 1, 4}));
    build.scene.orbit.elevation = 80;
    build.scene.orbit.distance = 2;
    return build.scene;
}

/// `count` lights over it, evenly about the middle.
Scene lit_scene(int count, bool casts) {
    Scene scene = floor_scene();
    for (int i = 0; i < count; ++i) {
        const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const float turn = 2.399963F * static_cast<float>(i), reach = 2 * std::sqrt(share);
        PointLight light;
        light.position = {reach * std::cos(turn), 1, reach * std::sin(turn)};
        light.intensity = glm::vec3(1.0F / static_cast<float>(count));
        light.casts_shadow = casts;
        light.aim = {light.position.x, 0, light.position.z};
        scene.lights.push_back(light);
    }
    return scene;
}

/// A ball of about so many triangles on it.
Scene ball_scene(int triangles) {
    SceneBuilder build;
    build.scene = floor_scene();
    const int rings = std::max(static_cast<int>(std::lround(std::sqrt(triangles / 4.0))), 2);
    build.place(build.mesh(sphere(rings, 2 * rings)), build.material({}),
                at({0, 0.4F, 0}, glm::vec3(0.4F)));
    return build.scene;
}

std::size_t triangles_of(const Scene& scene) {
    std::size_t indices = 0;
    for (const Object& object : scene.objects) {
        indices += scene.meshes[object.mesh].indices.size();
    }
    return indices / 3;
}

/// Situations and what they have of what grows.
struct Series {
    std::string name, amount_label, passes;
    Counts counts = nullptr;
    std::vector<double> amounts{};
    std::vector<Situation> situations{};

    void add(double amount, Situation situation) {
        amounts.push_back(amount);
        situations.push_back(std::move(situation));
    }
};

Series by_pixels(const Situation& situation) {
    Series out{"pixels", "pixels", "the frame of the input, but for its maps"};
    out.counts = [](std::string_view pass) {
        return !pass.starts_with("shadow of ") && !pass.starts_with("surroundings") &&
               pass != "reflectance";
    };
    const Size size = situation.settings.output;
    for (int k = 0; k < 5; ++k) {
        const double scale = std::exp2(-0.5 * (4 - k));
        Situation smaller = situation;
        smaller.settings.output = {
            std::max(static_cast<std::uint32_t>(std::lround(size.width * scale)), 8U),
            std::max(static_cast<std::uint32_t>(std::lround(size.height * scale)), 8U)};
        const Size pixels = smaller.settings.output;
        out.add(static_cast<double>(pixels.width) * pixels.height, std::move(smaller));
    }
    return out;
}

Series by_lights(const Situation& situation) {
    Series out{"lights", "lights", "lighting"};
    out.counts = [](std::string_view pass) { return pass == "lighting"; };
    for (const int count : {1, 4, 16, 64, 256, 1024, 4096}) {
        out.add(count, showing(situation, lit_scene(count, false)));
    }
    return out;
}

Series by_casting_lights(const Situation& situation) {
    Series out{"lights that cast shadows", "casting lights", "shadow maps and lighting"};
    out.counts = [](std::string_view pass) {
        return pass.starts_with("shadow of ") || pass == "lighting";
    };
    for (const int count : {1, 2, 4, 8, 16}) {
        Situation lit = showing(situation, lit_scene(count, true));
        lit.settings.shadow_size = 256;
        out.add(count, std::move(lit));
    }
    return out;
}

Series by_triangles(const Situation& situation, bool is_cpu) {
    Series out{"triangles", "triangles", "g-buffer"};
    out.counts = [](std::string_view pass) {
        return pass == "g-buffer" || pass == "triangles" || pass == "large triangles";
    };
    const int most = is_cpu ? 65536 : 1 << 22;
    for (int count = 256; count <= most; count *= 4) {
        Scene scene = ball_scene(count);
        const auto triangles = static_cast<double>(triangles_of(scene));
        out.add(triangles, showing(situation, std::move(scene)));
    }
    return out;
}

Series by_levels(const Situation& situation) {
    Series out{"levels of bloom", "levels", "bloom"};
    out.counts = [](std::string_view pass) { return pass.starts_with("bloom "); };
    Situation base = situation;
    Shown shown;
    shown.name = "windows";
    shown.picture = test_picture_named("windows")->make(situation.settings.output, 0);
    base.shown = std::make_shared<const Shown>(std::move(shown));
    base.settings.effects.clear();
    base.settings.bloom = bloom_named("dual-kawase");
    base.look_a = base.look_b = nullptr;
    const Size size = situation.settings.output;
    std::size_t before = 0;
    for (float radius = 0.05F; radius <= 8; radius *= 2) {
        base.settings.bloom_settings.radius = radius;
        const BloomPlan plan = bloom_plan(
            *base.settings.bloom, {static_cast<int>(size.width), static_cast<int>(size.height)},
            base.settings.bloom_settings);
        const std::size_t levels = (plan.steps.size() + 1) / 2; // down, and up but for the last
        if (levels > before) {
            out.add(static_cast<double>(levels), base);
            before = levels;
        }
    }
    return out;
}

} // namespace

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
    const auto count = static_cast<double>(x.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double u = std::log(x[i]), v = std::log(y[i]);
        sx += u;
        sy += v;
        sxx += u * u;
        sxy += u * v;
    }
    const double spread = count * sxx - sx * sx;
    return spread > 0 ? (count * sxy - sx * sy) / spread : 0;
}

std::vector<Growth> growth_of(Renderer& renderer, const Situation& situation, int rounds) {
    std::vector<Growth> out;
    for (const Series& series :
         {by_pixels(situation), by_lights(situation), by_casting_lights(situation),
          by_triangles(situation, renderer.is_cpu()), by_levels(situation)}) {
        const auto times = renderer.time(series.situations, series.counts, rounds);
        Growth growth{series.name, series.amount_label, series.passes, {}};
        std::vector<double> seconds;
        for (std::size_t i = 0; i < times.size(); ++i) {
            growth.points.push_back({series.amounts[i], times[i]});
            seconds.push_back(std::max(times[i].median, 1e-9));
        }
        growth.exponent = fitted_exponent(series.amounts, seconds);
        const auto half = static_cast<long>(seconds.size() / 2);
        growth.upper_exponent =
            fitted_exponent({series.amounts.begin() + half, series.amounts.end()},
                            {seconds.begin() + half, seconds.end()});
        out.push_back(std::move(growth));
        renderer.forget();
    }
    return out;
}

} // namespace preview::report
