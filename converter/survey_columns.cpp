#include "converter/survey_columns.h"

#include "lutlib/survey/pareto.h"

namespace converter {

std::vector<std::size_t> dominators_of(const lutlib::Survey& survey) {
    std::vector<std::array<double, 3>> points;
    for (const lutlib::SurveyRow& row : survey.rows) {
        points.push_back(
            {row.error.delta_e_2000.max, survey_costs[0].of(row), survey_costs[1].of(row)});
    }
    return lutlib::dominators<3>(points);
}

std::string short_name(const lutlib::Combination& c) {
    std::string out = std::to_string(c.size) + ", " + std::string(c.storage->label) + ", " +
                      std::string(c.lookup->label);
    if (c.shaper->name != "none") {
        out += ", " + std::string(c.shaper->name);
    }
    return out + (c.fitted ? ", fitted" : "");
}

std::size_t lookup_index(const lutlib::Lookup& lookup) {
    return static_cast<std::size_t>(&lookup - lutlib::lookups().data());
}

std::vector<plot::Series> lookup_series() {
    std::vector<plot::Series> out;
    for (const lutlib::Lookup& lookup : lutlib::lookups()) {
        out.push_back(
            {std::string(lutlib::is_emulated(lookup) ? "hardware, emulated" : lookup.label)});
    }
    return out;
}

std::string csv_line(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) {
        out += (out.empty() ? "" : ",") + word;
    }
    return out + "\n";
}

} // namespace converter
