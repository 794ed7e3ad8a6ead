#include "preview/check/check.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "preview/frame/frame.h"
#include "preview/frame/rasters.h"
#include "preview/passes/bloom_composite.h"

#include <fmt/format.h>

#include <algorithm>

namespace preview {

namespace {

constexpr std::string_view resolve_pass = "hdr resolve";

/// The resolve's place in the graph; without one everything stands behind it.
std::uint32_t resolve_order(const Graph& graph) {
    for (std::uint32_t order = 0; order < graph.passes().size(); ++order) {
        if (graph.passes()[order].name == resolve_pass) {
            return order;
        }
    }
    return 0;
}

void refuse_raster(const gpu::Device& device, const FrameSettings& settings) {
    if (settings.raster == Raster::compute) {
        (void)lutlib::find_named(rasters(), "compute")->on(device, settings.output);
    }
}

} // namespace

std::size_t CheckReport::failed() const {
    const auto count = [](const auto& results) {
        return static_cast<std::size_t>(std::count_if(
            results.begin(), results.end(), [](const auto& one) { return !one.faults.empty(); }));
    };
    return count(extremes) + count(plants) + count(nudges);
}

Checker::Checker(const gpu::Device& device, Situation situation)
    : device_(device), situation_(std::move(situation)), executor_(device) {}

FrameInputs Checker::inputs_of(const Situation& situation, std::optional<Scene>& moved) {
    if (!on_gpu_ || on_gpu_->shown() != situation.shown) {
        executor_.wait();
        on_gpu_.emplace(device_, situation.shown);
    }
    FrameInputs out = on_gpu_->inputs();
    if (situation.has_scene()) {
        out.lights = &situation.lights;
        out.surroundings = &situation.surroundings;
        const SceneInfo* const info = scene_named(situation.shown->name);
        if (info != nullptr && situation.settings.seconds != situation_.settings.seconds) {
            moved = scene_at(*info, situation.settings.seconds);
            out.scene = &*moved;
        }
    }
    out.look_a = situation.look_a;
    out.look_b = situation.look_b;
    return out;
}

Checker::Seen Checker::see(const Situation& situation, bool with_all_apart) {
    refuse_raster(device_, situation.settings);
    std::optional<Scene> moved;
    const FrameInputs inputs = inputs_of(situation, moved);
    Seen out;
    out.handles = build_frame(out.graph, inputs, situation.settings);
    if (with_all_apart && out.handles.bloom) {
        Finishing bloomed;
        bloomed.picture = out.handles.hdr;
        bloomed.bloom = out.handles.bloomed;
        out.graph.present(add_bloom_composite(out.graph, bloomed));
    }
    if (with_all_apart) {
        out.graph = with_lighting_apart(out.graph);
    }
    out.observed = observe(executor_, out.graph);
    return out;
}

FrameFinding finding_of(const Graph& graph, const std::vector<Observed>& observed) {
    const std::uint32_t resolve = resolve_order(graph);
    FrameFinding out;
    for (const Observed& one : observed) {
        const NonFinite bad = non_finite(one);
        out.passes.push_back({one.pass, one.name, one.texels(), bad});
        if (one.pass == "plant") {
            continue;
        }
        if (bad.all() > 0 && out.first_bad.empty()) {
            out.first_bad = one.pass;
        }
        (one.order < resolve ? out.before : out.after) += bad.all();
        out.nan_before += one.order < resolve ? bad.nan : 0;
    }
    return out;
}

ExtremeResult Checker::check(const Extreme& row) {
    ExtremeResult out{.name = row.name, .help = row.help};
    const Situation extreme = with_every_pass(changed(situation_, row));
    Seen seen;
    try {
        seen = see(extreme, true);
    } catch (const lutlib::Error& error) {
        out.skipped = error.message();
        return out;
    }
    out.frame = finding_of(seen.graph, seen.observed);
    out.twins = twin_figures(extreme, seen.graph, seen.observed);
    if (out.frame.after > 0) {
        out.faults.push_back(fmt::format("{} texels are not finite behind the HDR resolve, first "
                                         "of {}",
                                         out.frame.after, out.frame.first_bad));
    }
    if (out.frame.nan_before > 0 && !row.is_not_finite) {
        out.faults.push_back(fmt::format("{} texels are NaN before the HDR resolve, first of {}",
                                         out.frame.nan_before, out.frame.first_bad));
    }
    for (const TwinFigure& twin : out.twins) {
        if (!twin.keeps_light()) {
            out.faults.push_back(
                fmt::format("{} has {:+.2g} of its twin's light more, and may have "
                            "{:.2g}",
                            twin.pass, twin.drift, twin.drift_bound));
        }
        if (!twin.is_near()) {
            out.faults.push_back(fmt::format("{} is up to {:.3g} from its twin in double, and may "
                                             "be {:.3g}, in {} texels",
                                             twin.pass, twin.largest, twin.bound, twin.beyond));
        }
    }
    return out;
}

CheckReport run_check(Checker& checker, const std::function<void(const std::string&)>& progress) {
    CheckReport out;
    for (const Extreme& row : extremes(checker.situation())) {
        progress(row.name);
        out.extremes.push_back(checker.check(row));
    }
    progress("planted values");
    out.plants = checker.check_plants();
    for (const Nudge& row : nudges(checker.situation())) {
        progress("a millionth of " + row.name);
        out.nudges.push_back(checker.check(row));
    }
    return out;
}

} // namespace preview
