// What lutconv bake finds out about one bake, and how it says it.
#pragma once

#include "converter/explain.h"
#include "lutlib/bake/budget.h"
#include "lutlib/recipe/placement.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace converter {

/// The option that promises, its metric and its limit.
struct Promise {
    std::string_view option, label;
    lutlib::Metric metric;
    double most;
};

/// Everything, before any of it is written or printed.
struct BakeResult {
    std::string input, output; ///< as they were named
    std::string config;        ///< what OpenColorIO converts before the look; empty: nothing
    std::optional<Promise> promise;
    bool fit_wanted = false;
    lutlib::FilledBake filled;
    std::optional<lutlib::BudgetBake> budgeted; ///< with a promise
    std::string title;
    lutlib::Interpolation interpolation{}; ///< how the look was read
    lutlib::Domain domain;
    lutlib::LookPlace place;
    lutlib::Viewing viewing;                 ///< of what comes out
    std::optional<lutlib::Difference> error; ///< unless it was not to be measured
    std::optional<Explanation> explanation;

    bool is_kept() const { return !budgeted || budgeted->kept; }
    bool is_beyond_fitting() const {
        return fit_wanted && filled.bake.size > lutlib::largest_fitted_size;
    }
};

std::string to_text(const BakeResult& result);
nlohmann::ordered_json to_json(const BakeResult& result);

} // namespace converter
