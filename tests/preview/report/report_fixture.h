// A renderer and what it reports on, small.
#pragma once

#include "preview/effects/effect.h"
#include "preview/report/report.h"
#include "tests/preview/graph/gpu_test.h"
#include "tests/support/thorough.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

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

    /// Of the studio, each study once; bloom is as wide as a pyramid needs it in so few lines. Made
    /// for the first test that asks and looked at by all.
    static const RendererReport& whole() {
        static const RendererReport made = [] {
            Renderer renderer(device());
            return make_report({renderer, usual_studied_look()}, wide(showing("studio")), quick(),
                               [](const std::string&) {});
        }();
        return made;
    }
    static Situation wide(Situation situation) {
        situation.settings.bloom_settings.radius = 4;
        return situation;
    }
    static ReportSettings quick() {
        ReportSettings settings;
        settings.sizes = {size};
        settings.rounds = 1;
        settings.budget = 1e3;
        return settings;
    }

    /// Of one study: with all inputs that situation, else what the whole report has of it.
    std::vector<Row> rows_of_one(const Study& study, const Situation& situation, Size at) {
        if (support::is_thorough()) {
            return rows_made(study, situation, at);
        }
        std::vector<Row> rows;
        std::copy_if(whole().rows.begin(), whole().rows.end(), std::back_inserter(rows),
                     [&](const Row& row) { return row.study == &study; });
        return rows;
    }
    /// What the input of those is named.
    static std::string own(const Situation& situation) {
        return support::is_thorough() ? situation.shown->name : whole().input;
    }
    std::vector<Row> rows_made(const Study& study, const Situation& situation, Size at) {
        ReportSettings settings = quick();
        settings.sizes = {at};
        std::vector<LeftOutStudy> left_out;
        return rows_of(tools, study, situation, settings, left_out);
    }

    Renderer renderer;
    StudyTools tools;
};

} // namespace preview::report
