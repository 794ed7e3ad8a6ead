// What a check has found, as text and as JSON.
#include "preview/cli/check_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace preview {

namespace {

using nlohmann::json;

template <class Result>
std::string verdict(const Result& result) {
    std::string out = result.faults.empty() ? "ok" : "FAIL:";
    for (const std::string& fault : result.faults) {
        out += (&fault == result.faults.data() ? " " : "; ") + fault;
    }
    return out;
}

std::string first_bad(const FrameFinding& frame) {
    return frame.first_bad.empty() ? "-" : frame.first_bad;
}

/// The twin that is farthest for what it may be.
const TwinFigure* worst_twin(const std::vector<TwinFigure>& twins) {
    const TwinFigure* worst = nullptr;
    for (const TwinFigure& twin : twins) {
        if (worst == nullptr || twin.largest / twin.bound > worst->largest / worst->bound) {
            worst = &twin;
        }
    }
    return worst;
}

double worst_drift(const std::vector<TwinFigure>& twins) {
    double out = 0;
    for (const TwinFigure& twin : twins) {
        out = std::abs(twin.drift) > std::abs(out) ? twin.drift : out;
    }
    return out;
}

void add_extremes(terminal::Table& table, const CheckReport& report, bool only_faults) {
    table.heading(
        "Extreme inputs: texels that are not finite before and behind the HDR resolve, "
        "the pass that first has one, the farthest from a twin in double, drift of light");
    table.row({"input", "before", "behind", "first of", "twin", "drift", ""});
    for (const ExtremeResult& one : report.extremes) {
        if (only_faults && one.faults.empty()) {
            continue;
        }
        if (!one.skipped.empty()) {
            table.row({one.name, "", "", "", "", "", "left out: " + one.skipped});
            continue;
        }
        const TwinFigure* const twin = worst_twin(one.twins);
        table.row({one.name, std::to_string(one.frame.before), std::to_string(one.frame.after),
                   first_bad(one.frame),
                   twin != nullptr ? fmt::format("{:.1e} {}", twin->largest, twin->pass) : "-",
                   fmt::format("{:+.1e}", worst_drift(one.twins)), verdict(one)});
    }
}

void add_plants(terminal::Table& table, const CheckReport& report, bool only_faults) {
    if (report.plants.empty()) {
        return;
    }
    table.heading("Planted into one texel of what a pass reads: what is not finite then, and how "
                  "many texels far the resolved light changes");
    table.row({"image", "value", "before", "behind", "reach", ""});
    for (const PlantResult& one : report.plants) {
        if (!only_faults || !one.faults.empty()) {
            table.row({one.name, one.value, std::to_string(one.frame.before),
                       std::to_string(one.frame.after),
                       one.reach ? std::to_string(*one.reach) : "-", verdict(one)});
        }
    }
}

void add_nudges(terminal::Table& table, const CheckReport& report, bool only_faults) {
    table.heading("A value changed by a millionth: how far the finished picture moves, in codes of "
                  "255, and the pass that moves most for what it reads");
    table.row({"value", "largest", "p99", "over 1 code", "stiffest pass", "gain", ""});
    for (const NudgeResult& one : report.nudges) {
        if (!only_faults || !one.faults.empty()) {
            table.row({one.name, fmt::format("{:.3g}", one.largest), fmt::format("{:.3g}", one.p99),
                       fmt::format("{:.4f} %", 100 * one.moved),
                       one.stiffest.empty() ? "-" : one.stiffest, fmt::format("{:.3g}", one.gain),
                       verdict(one)});
        }
    }
}

json json_of(const FrameFinding& frame) {
    json passes = json::array();
    for (const PassCount& pass : frame.passes) {
        passes.push_back({{"pass", pass.pass},
                          {"image", pass.name},
                          {"texels", pass.texels},
                          {"nan", pass.bad.nan},
                          {"infinite", pass.bad.infinite}});
    }
    json out{{"before_resolve", frame.before}, {"behind_resolve", frame.after}, {"passes", passes}};
    out["first_bad_pass"] = frame.first_bad.empty() ? json() : json(frame.first_bad);
    return out;
}

/// JSON has no infinity: null stands for it.
json number_or_null(double value) {
    return std::isfinite(value) ? json(value) : json();
}

json json_of(const ExtremeResult& one) {
    json out{{"name", one.name}, {"help", one.help}, {"faults", one.faults}};
    if (!one.skipped.empty()) {
        out["left_out"] = one.skipped;
        return out;
    }
    out.update(json_of(one.frame));
    out["twins"] = json::array();
    for (const TwinFigure& twin : one.twins) {
        out["twins"].push_back({{"pass", twin.pass},
                                {"largest", number_or_null(twin.largest)},
                                {"bound", twin.bound},
                                {"beyond", twin.beyond},
                                {"energy_drift", number_or_null(twin.drift)},
                                {"drift_bound", twin.drift_bound}});
    }
    return out;
}

json json_of(const PlantResult& one) {
    json out{{"pass", one.pass}, {"image", one.name}, {"value", one.value}, {"faults", one.faults}};
    out.update(json_of(one.frame));
    out["reach"] = one.reach ? json(*one.reach) : json();
    return out;
}

json json_of(const NudgeResult& one) {
    json passes = json::array();
    for (const PassMove& pass : one.passes) {
        passes.push_back({{"pass", pass.pass},
                          {"image", pass.name},
                          {"largest", pass.largest},
                          {"p99", pass.p99},
                          {"mean", pass.mean}});
    }
    return {{"name", one.name},          {"help", one.help},
            {"faults", one.faults},      {"passes", passes},
            {"largest", one.largest},    {"p99", one.p99},
            {"moved", one.moved},        {"may_move", one.may_move},
            {"stiffest_gain", one.gain}, {"stiffest_pass", one.stiffest}};
}

template <class Result>
json list_of(const std::vector<Result>& results) {
    json out = json::array();
    for (const Result& one : results) {
        out.push_back(json_of(one));
    }
    return out;
}

} // namespace

terminal::Table table_of(const CheckReport& report, bool only_faults) {
    terminal::Table table;
    add_extremes(table, report, only_faults);
    add_plants(table, report, only_faults);
    add_nudges(table, report, only_faults);
    return table;
}

std::string to_json(const CheckReport& report, const std::string& device, Size size) {
    const json all{{"device", device},
                   {"width", size.width},
                   {"height", size.height},
                   {"passed", report.failed() == 0},
                   {"failed", report.failed()},
                   {"extremes", list_of(report.extremes)},
                   {"planted", list_of(report.plants)},
                   {"stiffness", list_of(report.nudges)}};
    return all.dump(2, ' ', true, json::error_handler_t::replace) + "\n";
}

} // namespace preview
