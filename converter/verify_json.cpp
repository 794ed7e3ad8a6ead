#include "converter/placing.h"
#include "converter/report.h"
#include "converter/verify_result.h"

#include <nlohmann/json.hpp>

namespace converter {
namespace {

nlohmann::ordered_json diagnosis_json(const lutlib::Diagnosis& diagnosis) {
    nlohmann::ordered_json out{{"words", diagnosis.words}};
    if (diagnosis.explained > 0) {
        out["explained"] = diagnosis.explained;
    }
    return out;
}

nlohmann::ordered_json fitted_json(const lutlib::FittedCheck& check) {
    return {{"result", to_json(check.result.absolute)},
            {"refit", to_json(check.refit.absolute)},
            {"point_sampled", to_json(check.point_sampled.absolute)},
            {"texels_moved", check.moved},
            {"faults", check.faults}};
}

} // namespace

nlohmann::ordered_json to_json(const Subject& s, const Verdict& v) {
    nlohmann::ordered_json out{{"picture", v.picture},
                               {"against", v.against},
                               {"oracle", v.oracle},
                               {"engine", s.engine->name},
                               {"engine_named_by", words_of(s.named_by).name},
                               {"layout", s.engine->layout},
                               {"size", s.size},
                               {"bits", s.codes.depth.bits},
                               {"contract_violations", s.contract},
                               {"notes", s.notes},
                               {"encodings", to_json(v.place)}};
    out["encodings"]["claimed_by_picture"] = v.claimed;
    if (is_a_matter_of_tags(s, v)) {
        out["tags_alone"] = s.tags;
    }
    if (!v.refusal.empty()) {
        out["oracle_refusal"] = v.refusal;
    }
    if (!v.scale.empty()) {
        out["oracle_scale"] = v.scale;
    }
    if (v.result) {
        const lutlib::TexelCheck& t = v.result->texels;
        const lutlib::Difference& lookup = v.result->lookup;
        out["texels"] = {{"count", t.texels},
                         {"wrong", t.wrong},
                         {"max_difference_codes", t.max_difference},
                         {"mean_difference_codes", t.mean_difference}};
        if (v.result->diagnosis) {
            out["diagnosis"] = diagnosis_json(*v.result->diagnosis);
        } else if (t.wrong > 0 && !v.fitted) {
            out["nearest"] = diagnosis_json(v.result->nearest);
        }
        out["lookup"] = {{"viewing", to_json(v.viewing)},
                         {"absolute_error", to_json(lookup.absolute)},
                         {"delta_e_2000", to_json(lookup.delta_e_2000)},
                         {"delta_e_itp", to_json(lookup.delta_e_itp)},
                         {"worst", {lookup.worst.in.r, lookup.worst.in.g, lookup.worst.in.b}}};
    }
    if (v.fitted) {
        out["fitted"] = fitted_json(*v.fitted);
    }
    out["passed"] = v.passed;
    out["verdict"] = verdict_text(s, v);
    return out;
}

} // namespace converter
