// Which settings of all passes to take for a budget: the front of all combinations of what the
// studies measured, and what was chosen from it, measured.
#pragma once

#include "lutlib/survey/timing.h"
#include "preview/report/errors.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace preview::report {

/// A variant of one pass.
struct ChoiceOption {
    std::string name;
    double seconds = 0, error = 0;
};

/// One option of each pass. Times and errors add up: errors that do not cancel each other come to
/// at most their sum.
struct Combination {
    std::vector<std::size_t> options; ///< of each pass, in order
    double seconds = 0, error = 0;
};

/// All combinations that no other beats in time and error, by rising time: exactly, of however many
/// there are (passes are added one by one, and what is beaten then stays beaten).
std::vector<Combination> combination_front(std::span<const std::vector<ChoiceOption>> passes);

/// The last that takes no longer; null when even the first does.
const Combination* within_budget(std::span<const Combination> front, double seconds);

/// A combination that was rendered and timed as a whole.
struct MeasuredCombination {
    Combination predicted;
    PictureError error;  ///< against a frame four times as wide and high with every pass converged
    lutlib::Timing time; ///< of the whole frame
};

/// What more time buys.
struct BudgetStep {
    double budget = 0; ///< seconds
    std::size_t combination = 0;
};

struct Choice {
    std::vector<std::string> passes;
    std::vector<std::vector<ChoiceOption>> options; ///< of each pass
    std::vector<Combination> front;                 ///< seconds of the whole frame, as predicted
    std::vector<BudgetStep> steps;
    double step = 0;              ///< seconds from one to the next
    std::size_t chosen = 0;       ///< of the front
    std::string why;              ///< a sentence
    bool is_kept = true;          ///< the budget or the error that was asked for
    MeasuredCombination measured; ///< the chosen one
    MeasuredCombination usual;    ///< as the program renders unless it is told otherwise
};

} // namespace preview::report
