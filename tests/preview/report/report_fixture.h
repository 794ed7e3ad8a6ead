// A renderer and what it reports on, small.
#pragma once

#include "preview/effects/effect.h"
#include "preview/report/report.h"
#include "tests/preview/graph/gpu_test.h"

namespace preview::report {

class ReportTest : public GpuTest {
  protected:
    static constexpr Size size{48, 27};

    ReportTest() : renderer(device()), tools{renderer, usual_studied_look()} {}

    static Situation showing(std::string_view scene) {
        Shown shown;
        shown.name = scene;
        shown.scene = scene_at(*scene_named(scene), 0);
        Situation out;
        out.settings.output = size;
        out.settings.shadow_size = 256;
        out.settings.orbit = shown.scene->orbit;
        out.lights = shown.scene->lights;
        out.surroundings = shown.scene->surroundings;
        set_usual(out.settings.effects, true);
        out.shown = std::make_shared<const Shown>(std::move(shown));
        return out;
    }

    Renderer renderer;
    StudyTools tools;
};

} // namespace preview::report
