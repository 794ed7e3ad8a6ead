#include "converter/bake_result.h"
#include "converter/placing.h"
#include "converter/report.h"
#include "lutlib/io/bake_report.h"

#include <nlohmann/json.hpp>

namespace converter {
namespace {

nlohmann::ordered_json bake_json(const BakeResult& result) {
    const lutlib::Bake& bake = result.filled.bake;
    const lutlib::io::Reach reach = lutlib::io::reach_of(result.domain, result.place.applied());
    nlohmann::ordered_json out{{"input", result.input},
                               {"output", result.output},
                               {"engine", bake.engine->name},
                               {"layout", bake.engine->layout},
                               {"width", bake.picture.width},
                               {"height", bake.picture.height},
                               {"size", bake.size},
                               {"bits", bake.picture.depth.bits},
                               {"srgb_tag", bake.engine->srgb_tag == lutlib::SrgbTag::present},
                               {"encodings", to_json(result.place)},
                               {"loss",
                                {{"clamped_values", bake.loss.clamped_values},
                                 {"most_clamped", bake.loss.most_clamped},
                                 {"reachable_domain_share", reach.reached},
                                 {"clamped_input_share", reach.clamped},
                                 {"max_rounding", bake.loss.max_rounding},
                                 {"mean_rounding", bake.loss.mean_rounding}}},
                               {"fitted", result.filled.fitted},
                               {"viewing", to_json(result.viewing)}};
    if (result.error) {
        out["absolute_error"] = to_json(result.error->absolute);
        out["delta_e_2000"] = to_json(result.error->delta_e_2000);
        out["delta_e_itp"] = to_json(result.error->delta_e_itp);
    }
    return out;
}

nlohmann::ordered_json fit_json(const lutlib::FilledBake& filled) {
    const lutlib::Difference &before = *filled.point_sampled, &after = *filled.result;
    return {
        {"point_sampled", to_json(before.absolute)},
        {"result", to_json(after.absolute)},
        {"delta_e_2000",
         {{"point_sampled", to_json(before.delta_e_2000)},
          {"result", to_json(after.delta_e_2000)}}},
        {"delta_e_itp",
         {{"point_sampled", to_json(before.delta_e_itp)}, {"result", to_json(after.delta_e_itp)}}},
        {"grey_tint", {{"point_sampled", filled.tint_of_point_samples}, {"result", filled.tint}}},
        {"look_clamped_values", filled.look_loss.clamped_values},
        {"look_most_clamped", filled.look_loss.most_clamped}};
}

nlohmann::ordered_json budget_json(const Promise& promise, const lutlib::BudgetBake& found) {
    return {{promise.metric == lutlib::Metric::delta_e_itp ? "max_delta_itp" : "max_delta_e",
             promise.most},
            {"kept", found.kept},
            {"tried", found.tried},
            {"bytes",
             lutlib::lattice_bytes(found.filled.bake.size, found.filled.bake.picture.depth.bits)},
            {"largest", found.largest}};
}

} // namespace

nlohmann::ordered_json to_json(const BakeResult& result) {
    nlohmann::ordered_json json = bake_json(result);
    if (!result.config.empty()) {
        json["ocio_config"] = result.config;
    }
    if (result.filled.result) {
        json["fit"] = fit_json(result.filled);
    }
    if (result.is_beyond_fitting()) {
        json["notes"] = {"not fitted: " + lutlib::fit_limit_text()};
    }
    if (result.budgeted) {
        json["budget"] = budget_json(*result.promise, *result.budgeted);
    }
    if (result.explanation) {
        json["explanation"] = to_json(*result.explanation);
    }
    return json;
}

} // namespace converter
