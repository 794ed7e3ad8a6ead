#include "lutlib/health/repair.h"

#include "lutlib/health/health.h"
#include "lutlib/health/parts.h"
#include "lutlib/health/repair_parts.h"
#include "lutlib/metrics/viewing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace health {

OutputRange finite_range(const std::vector<Rgb>& outputs) {
    OutputRange out{INFINITY, -INFINITY};
    for (const Rgb& value : outputs) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (std::isfinite(value[c])) {
                out.low = std::min(out.low, static_cast<double>(value[c]));
                out.high = std::max(out.high, static_cast<double>(value[c]));
            }
        }
    }
    return out;
}

std::string clamp_outputs(Lut& lut, const RepairOptions& options) {
    std::vector<Rgb>* const outputs = !options.clamp ? nullptr
                                      : lut.cube     ? &lut.cube->nodes
                                      : lut.shaper   ? &lut.shaper->entries
                                                     : nullptr;
    bool done = false;
    for (std::size_t i = 0; outputs && i < outputs->size(); ++i) {
        const Rgb held = saturate((*outputs)[i]);
        done = done || !(held == (*outputs)[i]);
        (*outputs)[i] = held;
    }
    return done ? "outputs are clamped to 0..1" : "";
}

} // namespace health

namespace {

// Those that are needed, or were asked for, whatever else they bring.
constexpr std::array<std::string_view, 3> needed{"non-finite", "1d-table", "clamp"};

constexpr std::array<RepairInfo, 5> repair_rows{{
    {"non-finite", "fills values that are not numbers from their neighbours",
     health::fill_non_finite},
    {"1d-table", "flattens a 1D table where it is not monotonic", health::straighten_table},
    {"spikes", "levels single nodes that stand out", health::level_spikes},
    {"neutral-axis", "stops brighter neutrals from becoming darker", health::straighten_neutrals},
    {"clamp", "clamps outputs to 0..1, when asked to", health::clamp_outputs},
}};

// A repair may make room for an earlier one: a levelled spike shows a smaller one beside it, and
// clamped neutrals may fall. Noise, the worst of looks, is done after 40 rounds at most, as each
// moves less by half or so; a look beyond the bound would still be moving by its last bits.
constexpr int most_rounds = 100;

void count_changes(const std::vector<Rgb>& before, const std::vector<Rgb>& after,
                   RepairStep& step) {
    for (std::size_t i = 0; i < before.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = before[i][c], b = after[i][c];
            if (a == b) {
                continue;
            }
            ++step.changed;
            step.largest =
                std::isfinite(a) ? std::max(step.largest, std::abs(a - b)) : step.largest;
        }
    }
}

// What the eye sees of the change, at the nodes or entries that changed and were finite; of a 1D
// table before a cube, along the neutrals.
ErrorStats seen(const Lut& before, const Lut& after) {
    std::vector<RgbD> a, b;
    const auto compare_values = [&](const std::vector<Rgb>& was, const std::vector<Rgb>& is) {
        for (std::size_t i = 0; i < was.size(); ++i) {
            if (health::finite(was[i]) && !(was[i] == is[i])) {
                a.push_back(to_double(was[i]));
                b.push_back(to_double(is[i]));
            }
        }
    };
    if (before.cube) {
        compare_values(before.cube->nodes, after.cube->nodes);
    } else if (before.shaper) {
        compare_values(before.shaper->entries, after.shaper->entries);
    }
    const bool shaped = before.cube && before.shaper && !(before.shaper == after.shaper);
    for (int i = 0; shaped && i < before.shaper->size(); ++i) {
        const RgbD in = entry_position(*before.shaper, i);
        const RgbD was = Transform::of(before)(in), is = Transform::of(after)(in);
        if (std::isfinite(largest_magnitude(was))) {
            a.push_back(was);
            b.push_back(is);
        }
    }
    std::vector<double> errors(a.size());
    const health::Codes codes = health::codes_of(before, {});
    const Eye eye{Viewing(codes.output)};
    eye(codes.results == Results::hdr ? Metric::delta_e_itp : Metric::delta_e_2000, a, b, errors);
    return error_stats(std::move(errors));
}

// What a repair must not make worse. How steep a look is to the eye is not among them: what a spike
// hid comes to light where it goes.
constexpr std::array<std::string_view, 8> guarded{"non-finite", "range",     "1d-table",
                                                  "cut-off",    "fold-over", "neutral-axis",
                                                  "clipping",   "plateaus"};

// The first of those checks that judges worse than before.
const HealthCheck* made_worse(const Health& before, const Health& after) {
    for (const HealthCheck& check : health_checks()) {
        if (std::find(guarded.begin(), guarded.end(), check.name) == guarded.end()) {
            continue;
        }
        if (check.judge(after).severity > check.judge(before).severity) {
            return &check;
        }
    }
    return nullptr;
}

// One repair, entered into the steps. False where there was nothing to do, or nothing that would
// not do harm.
bool make(const RepairInfo& row, const RepairOptions& options, Repaired& out) {
    Lut after = out.lut;
    const std::string words = row.apply(after, options);
    if (words.empty()) {
        return false;
    }
    if (std::find(needed.begin(), needed.end(), row.name) == needed.end()) {
        const ExamineOptions quick{.lattices = false};
        const HealthCheck* const worse = made_worse(examine(out.lut, quick), examine(after, quick));
        if (worse) {
            const std::string left = std::string(row.name) +
                                     ": not repaired, as its repair would "
                                     "make " +
                                     std::string(worse->name) + " worse";
            if (std::find(out.left.begin(), out.left.end(), left) == out.left.end()) {
                out.left.push_back(left);
            }
            return false;
        }
    }
    auto step = std::find_if(out.steps.begin(), out.steps.end(),
                             [&row](const RepairStep& s) { return s.name == row.name; });
    if (step == out.steps.end()) {
        step = out.steps.insert(step, RepairStep{.name = row.name, .words = words});
    }
    if (out.lut.shaper) {
        count_changes(out.lut.shaper->entries, after.shaper->entries, *step);
    }
    if (out.lut.cube) {
        count_changes(out.lut.cube->nodes, after.cube->nodes, *step);
    }
    const ErrorStats now = seen(out.lut, after);
    step->to_eye = now.max > step->to_eye.max ? now : step->to_eye;
    out.lut = std::move(after);
    return true;
}

} // namespace

std::span<const RepairInfo> repairs() {
    return repair_rows;
}

Repaired repair(const Lut& lut, const RepairOptions& options) {
    Repaired out{lut, {}, {}};
    bool changed = true;
    for (int round = 0; round < most_rounds && changed; ++round) {
        changed = false;
        for (const RepairInfo& row : repair_rows) {
            changed = make(row, options, out) || changed;
        }
    }
    return out;
}

} // namespace lutlib
