#include "preview/report/choose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace preview::report {

namespace {

constexpr double finest_step = 1e-4; // seconds
constexpr int most_steps = 20;

/// A pass that may be chosen of: its variants, and which of them is the usual one.
struct Pass {
    const Study* study = nullptr;
    std::vector<Variant> variants;
    std::vector<ChoiceOption> options;
    std::size_t usual = 0;
};

Size largest(const std::vector<Size>& sizes) {
    return *std::max_element(sizes.begin(), sizes.end(), [](Size a, Size b) {
        return std::uint64_t{a.width} * a.height < std::uint64_t{b.width} * b.height;
    });
}

const Row* row_of(const std::vector<Row>& rows, const Study& study, const std::string& input,
                  Size size, const std::string& variant) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return row.study == &study && row.input == input && row.size == size &&
               row.variant == variant;
    });
    return found == rows.end() ? nullptr : &*found;
}

/// Those that this input has and a budget may vary, whose usual variant is among the measured ones.
std::vector<Pass> passes_of(const StudyTools& tools, const Situation& situation, Size size,
                            const std::vector<Row>& rows) {
    std::vector<Pass> out;
    for (const Study* const study : studies()) {
        if (!study->none_because(situation).empty() ||
            (study->is_budgeted != nullptr && !study->is_budgeted(situation))) {
            continue;
        }
        Pass pass;
        pass.study = study;
        bool has_usual = false;
        for (Variant& variant : study->variants(studied(situation, size), tools)) {
            const Row* const row = row_of(rows, *study, situation.shown->name, size, variant.name);
            if (row == nullptr || !variant.is_choice) {
                continue;
            }
            if (variant.is_usual) {
                has_usual = true;
                pass.usual = pass.options.size();
            }
            pass.options.push_back({variant.name, row->time.median, row->picture.delta_e_2000.p99});
            pass.variants.push_back(std::move(variant));
        }
        if (has_usual && pass.options.size() > 1) {
            out.push_back(std::move(pass));
        }
    }
    return out;
}

Situation with_options(Situation situation, const std::vector<Pass>& passes,
                       const std::vector<std::size_t>& options) {
    for (std::size_t i = 0; i < passes.size(); ++i) {
        passes[i].variants[options[i]].set(situation);
    }
    return situation;
}

/// Measures combinations as whole frames.
class Judge {
  public:
    Judge(const StudyTools& tools, const Situation& base, const std::vector<Pass>& passes,
          int rounds)
        : tools_(tools), base_(base), passes_(passes), rounds_(rounds) {
        Situation all = base;
        for (const Pass& pass : passes) {
            if (pass.study->converge != nullptr) {
                pass.study->converge(all, tools);
            }
        }
        truth_ = supersampled(tools.renderer, all, supersamples);
    }

    MeasuredCombination measure(const Combination& combination) const {
        const std::vector<Situation> one{with_options(base_, passes_, combination.options)};
        return {combination, picture_error(tools_.renderer.render(one.front()).finished, truth_),
                tools_.renderer
                    .time(
                        one, [](std::string_view) { return true; }, rounds_)
                    .front()};
    }

  private:
    const StudyTools& tools_;
    const Situation& base_;
    const std::vector<Pass>& passes_;
    int rounds_;
    reference::Image truth_;
};

/// A step of a tenth of a millisecond, or of a round number where that would be too many.
double step_for(double range) {
    double step = finest_step;
    for (int i = 0; range / step > most_steps; ++i) {
        step *= i % 3 == 1 ? 2.5 : 2;
    }
    return step;
}

void find_steps(Choice& choice) {
    const double first = choice.front.front().seconds, last = choice.front.back().seconds;
    choice.step = step_for(last - first);
    for (double budget = choice.step * std::ceil(first / choice.step);; budget += choice.step) {
        const Combination* const best = within_budget(choice.front, budget);
        if (best != nullptr) {
            choice.steps.push_back({budget, static_cast<std::size_t>(best - choice.front.data())});
        }
        if (budget >= last) {
            return;
        }
    }
}

void choose_by_budget(Choice& choice, const Judge& judge, double budget) {
    const Combination* const best = within_budget(choice.front, budget);
    choice.is_kept = best != nullptr;
    choice.chosen = best != nullptr ? static_cast<std::size_t>(best - choice.front.data()) : 0;
    choice.measured = judge.measure(choice.front[choice.chosen]);
    choice.why = choice.is_kept
                     ? fmt::format("the smallest error within {:.3g} ms a frame", 1e3 * budget)
                     : fmt::format("no combination stays within {:.3g} ms a frame; this is the "
                                   "fastest",
                                   1e3 * budget);
}

/// From the fastest on; what was predicted says where to begin, what is measured decides.
void choose_by_error(Choice& choice, const Judge& judge, double most) {
    for (std::size_t i = 0; i < choice.front.size(); ++i) {
        const bool is_last = i + 1 == choice.front.size();
        // A sum of errors is more than what comes of them together, seldom more than twice.
        if (choice.front[i].error > 2 * most && !is_last) {
            continue;
        }
        choice.chosen = i;
        choice.measured = judge.measure(choice.front[i]);
        choice.is_kept = choice.measured.error.delta_e_2000.p99 <= most;
        if (choice.is_kept) {
            break;
        }
    }
    choice.why = choice.is_kept
                     ? fmt::format("the fastest whose dE2000 stays within {:.3g} at 99 % of the "
                                   "pixels",
                                   most)
                     : fmt::format("no combination keeps dE2000 within {:.3g} at 99 % of the "
                                   "pixels; this is the best",
                                   most);
}

} // namespace

std::optional<Choice> choice_of(const StudyTools& tools, const Situation& situation,
                                const ReportSettings& settings, const std::vector<Row>& rows) {
    const Size size = largest(settings.sizes);
    const std::vector<Pass> passes = passes_of(tools, situation, size, rows);
    if (passes.empty()) {
        return std::nullopt;
    }
    const Situation base = studied(situation, size);
    const Judge judge(tools, base, passes, settings.rounds);
    Choice out;
    Combination usual;
    for (const Pass& pass : passes) {
        out.passes.emplace_back(pass.study->name);
        out.options.push_back(pass.options);
        usual.options.push_back(pass.usual);
        usual.seconds += pass.options[pass.usual].seconds;
        usual.error += pass.options[pass.usual].error;
    }
    out.usual = judge.measure(usual);
    // What no study varies costs the same in every combination.
    const double rest = out.usual.time.median - usual.seconds;
    out.usual.predicted.seconds += rest;
    out.front = combination_front(out.options);
    for (Combination& one : out.front) {
        one.seconds += rest;
    }
    find_steps(out);
    if (settings.max_delta_e) {
        choose_by_error(out, judge, *settings.max_delta_e);
    } else {
        choose_by_budget(out, judge, settings.budget.value_or(out.usual.time.median));
    }
    if (!settings.max_delta_e && !settings.budget) {
        out.why = "the smallest error in the time that the usual settings take";
    }
    return out;
}

} // namespace preview::report
