#include "preview/report/leaving_out.h"

#include "preview/effects/effect.h"
#include "preview/report/test_pictures.h"
#include "preview/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace preview::report {

namespace {

/// Nothing but the tone map.
Situation bare(Situation s) {
    s.settings.effects.clear();
    s.settings.force_all = false;
    s.settings.bloom = bloom_named("none");
    s.settings.without = {};
    for (const EffectInfo& row : effects) {
        s.settings.without.set(row.effect, row.effect != Effect::tonemap);
    }
    s.look_a = s.look_b = nullptr;
    return s;
}

Situation with_picture(Situation s, std::string_view name, float exposure) {
    Shown shown;
    shown.name = name;
    shown.picture = test_picture_named(name)->make(s.settings.output, 0);
    s.shown = std::make_shared<const Shown>(std::move(shown));
    s.settings.exposure = exposure;
    return s;
}

Situation with_scene(Situation s, const Situation& from) {
    if (from.has_scene()) {
        s.shown = from.shown;
        s.lights = from.lights;
        s.surroundings = from.surroundings;
        s.settings.orbit = from.settings.orbit;
        s.settings.exposure = from.settings.exposure;
        return s;
    }
    Shown shown;
    shown.name = "sample";
    shown.scene = scene_at(*scene_named("sample"), 0);
    s.settings.exposure = 0;
    s.settings.orbit = shown.scene->orbit;
    s.lights = shown.scene->lights;
    s.surroundings = shown.scene->surroundings;
    s.shown = std::make_shared<const Shown>(std::move(shown));
    return s;
}

/// Adds stages, each with all that those before it have.
class Stages {
  public:
    explicit Stages(Situation first) : now_(std::move(first)) {}

    void add(std::string name, const std::function<void(Situation&)>& change) {
        change(now_);
        all_.push_back({std::move(name), now_});
    }
    std::vector<SavingStage> take() { return std::move(all_); }

  private:
    Situation now_;
    std::vector<SavingStage> all_;
};

void use_effect(Situation& s, std::string_view name, std::string_view parameter = {},
                double value = 0) {
    EffectUse use = usual_use(*post_effect_named(name));
    if (!parameter.empty()) {
        set_number(use, parameter, value);
    }
    put_use(s.settings.effects, std::move(use));
}

} // namespace

std::vector<SavingStage> saving_stages(const Situation& situation, const GpuLook* look) {
    const auto put_back = [](Situation& s, Effect part) { s.settings.without.set(part, false); };
    const Bloom* const bloom = situation.settings.bloom != bloom_named("none")
                                   ? situation.settings.bloom
                                   : bloom_named("glare");
    Stages stages(with_picture(bare(situation), "windows", -12));
    stages.add("a bare HDR picture, no light of which blooms", [](Situation&) {});
    stages.add("with bloom asked for", [&](Situation& s) {
        put_back(s, Effect::bloom);
        s.settings.bloom = bloom;
    });
    stages.add("with light that blooms", [](Situation& s) { s.settings.exposure = 0; });
    stages.add("with a look", [&](Situation& s) {
        put_back(s, Effect::looks);
        s.look_a = look;
    });
    stages.add("with effects of strength 0", [](Situation& s) {
        use_effect(s, "vignette", "strength", 0);
        use_effect(s, "sharpen", "strength", 0);
    });
    stages.add("the scene, unlit", [&](Situation& s) {
        s = with_scene(std::move(s), situation);
        put_back(s, Effect::floor);
        put_back(s, Effect::specular_aa);
    });
    stages.add("with its surroundings", [&](Situation& s) { put_back(s, Effect::environment); });
    stages.add("with its lights", [&](Situation& s) { put_back(s, Effect::lights); });
    stages.add("with lights that are dark", [](Situation& s) {
        for (int i = 0; i < 4; ++i) {
            PointLight dark;
            dark.position = {0, 1 + static_cast<float>(i), 0};
            s.lights.push_back(dark);
        }
    });
    stages.add("with shadows", [&](Situation& s) { put_back(s, Effect::shadows); });
    stages.add("with ambient occlusion", [&](Situation& s) { put_back(s, Effect::occlusion); });
    stages.add("with depth of field of an aperture that blurs nothing",
               [](Situation& s) { use_effect(s, "depth-of-field", "aperture", 64); });
    stages.add("under a sky", [](Situation& s) { s.surroundings.kind = SurroundingsKind::sky; });
    stages.add("the full scene, with antialiasing and what is in use besides", [&](Situation& s) {
        s.settings.effects = situation.settings.effects;
        set_usual(s.settings.effects, true);
        use_effect(s, "vignette");
    });
    return stages.take();
}

double largest_difference(const reference::Image& a, const reference::Image& b) {
    double out = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double apart = std::abs(a.pixels[i][c] - b.pixels[i][c]);
            out = std::isnan(apart) ? HUGE_VAL : std::max(out, apart);
        }
    }
    return out;
}

SavingRow saving_of(Renderer& renderer, const SavingStage& stage, int rounds) {
    Situation forced = stage.situation;
    forced.settings.force_all = true;
    SavingRow out;
    out.name = stage.name;
    out.bound = stage.bound;
    reference::Image wanted, got;
    std::tie(out.forced, wanted) = renderer.costs_of(forced, rounds);
    std::tie(out.usual, got) = renderer.costs_of(stage.situation, rounds);
    out.largest = largest_difference(wanted, got);
    return out;
}

} // namespace preview::report
