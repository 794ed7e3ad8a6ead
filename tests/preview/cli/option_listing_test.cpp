// What the command line lists, its help, and what it prints as JSON.
#include "preview/cli/headless.h"
#include "preview/cli/look_options.h"
#include "preview/cli/option_listing.h"
#include "preview/cli/option_rows.h"
#include "preview/effects/effect.h"
#include "preview/frame/frame.h"
#include "preview/look/cube_settings.h"
#include "preview/look/gpu_lookups.h"
#include "preview/scene/light_controls.h"
#include "tests/preview/cli/parsed.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace preview {
namespace {

TEST(Listing, names_every_row_of_every_table) {
    const std::string text = listing().text();
    const auto expect = [&](std::string_view name) {
        EXPECT_NE(text.find("  " + std::string(name) + " "), std::string::npos) << name;
    };
    for (const auto& row : picture_choices()) {
        for (const Option& option : row.options()) {
            expect(option.name);
        }
    }
    for (const auto& row : option_choices()) {
        for (const Option& option : row.options()) {
            expect(option.name);
        }
    }
    for (const NumberRow<PictureSettings>& row : picture_numbers()) {
        expect("--" + std::string(row.flag));
    }
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        expect("--" + std::string(row.flag));
    }
    for (const NumberRow<Surroundings>& row : surroundings_numbers()) {
        expect("--" + std::string(row.flag));
    }
    for (const SurroundingsInfo& row : surroundings_kinds()) {
        expect(row.name);
    }
    for (const NumberRow<CubeView>& row : cube_numbers()) {
        expect("--" + std::string(row.flag));
    }
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        expect("--" + std::string(row.flag));
    }
    for (const PostEffect* effect : post_effects()) {
        expect(effect->name);
        for (const lutlib::Parameter& parameter : effect->parameters) {
            expect("  " + std::string(parameter.name));
        }
    }
    for (const SceneInfo& row : scenes()) {
        expect(row.name);
    }
    for (const GpuLookup& row : gpu_lookups()) {
        expect(row.name);
    }
    for (const EffectInfo& row : effects) {
        expect(row.name);
    }
    for (const LightControl& row : light_controls()) {
        expect(row.name);
    }
}

TEST(Help, shows_defaults) {
    Options options;
    CLI::App app;
    declare(app, options);
    const std::string help = app.help();
    EXPECT_NE(help.find("=agx"), std::string::npos);
    EXPECT_NE(help.find("=0.5"), std::string::npos); // --split
    EXPECT_NE(help.find("=24"), std::string::npos);  // --frame-rate
    EXPECT_NE(help.find("--shadow-size UINT:in [16 - 8192]\n"), std::string::npos)
        << "what a default stands for is said in words";
}

TEST(ReportTest, is_one_document_whatever_it_holds) {
    Report report;
    report.probe = Probe{};
    report.figures = DifferenceFigures{.max = 2, .p99 = 1, .p95 = 1, .mean = 0.5};
    report.explanation = "kept finish\nleft out bloom\n";
    report.timings = Timings{};
    const std::string text = to_json(report);
    for (const char* key : {"\"probe\"", "\"difference\"", "\"explanation\"", "\"passes\""}) {
        EXPECT_NE(text.find(key), std::string::npos) << key;
    }
    EXPECT_EQ(text.find("\n}\n"), text.size() - 3); // closed once, at its end
    Report alone;
    alone.probe = Probe{};
    EXPECT_EQ(to_json(alone), probe_json(Probe{}, {}));
}

} // namespace
} // namespace preview
