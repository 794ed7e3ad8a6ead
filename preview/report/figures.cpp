#include "preview/report/figures.h"

#include "preview/report/columns.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace preview::report {

namespace {

using nlohmann::ordered_json;

/// JSON has no infinity: null stands for it.
ordered_json number(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json();
}

ordered_json json_of(const lutlib::Timing& time) {
    return {{"median", 1e3 * time.median},
            {"low_95", 1e3 * time.low},
            {"high_95", 1e3 * time.high},
            {"best", 1e3 * time.best},
            {"repetitions", time.repetitions}};
}

ordered_json json_of(const PictureError& error) {
    const auto stats = [](const lutlib::ErrorStats& s) {
        return ordered_json{
            {"mean", number(s.mean)}, {"p99", number(s.p99)}, {"max", number(s.max)}};
    };
    return {{"relative_l2", number(error.relative_l2)},
            {"largest_code", number(error.largest)},
            {"delta_e_2000", stats(error.delta_e_2000)},
            {"delta_e_itp", stats(error.delta_e_itp)}};
}

ordered_json json_of(const PassError& error) {
    ordered_json out{{"relative_l2", number(error.relative_l2)},
                     {"energy_drift", number(error.drift)}};
    const auto add = [&](const char* name, const std::optional<double>& value) {
        if (value) {
            out[name] = number(*value);
        }
    };
    add("radial_asymmetry", error.asymmetry);
    add("centroid_shift", error.centroid_shift);
    add("temporal_unrest", error.unrest);
    return out;
}

ordered_json json_of(const RendererReport& report, const Row& row, std::size_t index) {
    ordered_json out{{"study", row.study->name},
                     {"input", row.input},
                     {"width", row.size.width},
                     {"height", row.size.height},
                     {"variant", row.variant},
                     {"usual", row.is_usual},
                     {"aims_at_the_usual_picture", row.is_choice}};
    if (row.pass) {
        out["pass"] = json_of(*row.pass);
    }
    out["picture"] = json_of(row.picture);
    out[report.is_cpu ? "cpu_milliseconds" : "gpu_milliseconds"] = json_of(row.time);
    out["on_front"] = is_on_front(row, index);
    if (!is_on_front(row, index)) {
        out["dominated_by"] = row.dominated_by;
    }
    return out;
}

ordered_json json_of(const Choice& choice, const Combination& combination) {
    ordered_json settings;
    for (std::size_t i = 0; i < choice.passes.size(); ++i) {
        settings[choice.passes[i]] = choice.options[i][combination.options[i]].name;
    }
    return {{"settings", settings},
            {"predicted_milliseconds", 1e3 * combination.seconds},
            {"predicted_delta_e_2000_p99", number(combination.error)}};
}

ordered_json json_of(const Choice& choice, const MeasuredCombination& measured) {
    ordered_json out = json_of(choice, measured.predicted);
    out["measured"] = json_of(measured.error);
    out["measured"]["milliseconds"] = json_of(measured.time);
    return out;
}

ordered_json json_of(const Choice& choice) {
    ordered_json out{{"why", choice.why},
                     {"kept", choice.is_kept},
                     {"chosen", json_of(choice, choice.measured)},
                     {"usual", json_of(choice, choice.usual)},
                     {"step_milliseconds", 1e3 * choice.step}};
    for (const BudgetStep& step : choice.steps) {
        ordered_json row{{"budget_milliseconds", 1e3 * step.budget}};
        row.update(json_of(choice, choice.front[step.combination]));
        out["budgets"].push_back(std::move(row));
    }
    return out;
}

ordered_json json_of(const Costs& costs) {
    return {{"passes", costs.passes},
            {"bytes_moved", costs.bytes},
            {"memory_bytes", costs.memory},
            {"milliseconds", json_of(costs.time)}};
}

ordered_json json_of(const Growth& growth) {
    ordered_json out{{"of", growth.name},
                     {"passes", growth.passes},
                     {"exponent", growth.exponent},
                     {"exponent_of_upper_half", growth.upper_exponent}};
    for (const GrowthPoint& point : growth.points) {
        out["points"].push_back(
            {{growth.amount_label, point.amount}, {"milliseconds", json_of(point.time)}});
    }
    return out;
}

ordered_json json_of(const GlareModel& glare) {
    ordered_json out{{"field_of_view", glare.field_of_view},
                     {"largest_difference", glare.largest},
                     {"at_radius", glare.at_radius},
                     {"best_field_of_view", glare.best_field_of_view},
                     {"best_largest_difference", glare.best_largest}};
    for (const EncircledLight& at : glare.curve) {
        out["encircled"].push_back(
            {{"radius", at.radius}, {"model", at.model}, {"spencer_1995", at.measured}});
    }
    return out;
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) {
        return text;
    }
    std::string out = "\"";
    for (const char c : text) {
        out += c == '"' ? "\"\"" : std::string(1, c);
    }
    return out + "\"";
}

std::string csv_line(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) {
        out += &word == words.data() ? "" : ",";
        out += csv_cell(word);
    }
    return out + "\n";
}

} // namespace

std::string to_json(const RendererReport& report) {
    ordered_json out{{"input", report.input},
                     {"look", report.look},
                     {"device", report.device},
                     {"is_a_cpu", report.is_cpu},
                     {"recommendation", recommendation_text(report)},
                     {"rows", ordered_json::array()}};
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        out["rows"].push_back(json_of(report, report.rows[i], i));
    }
    for (const LeftOutStudy& study : report.left_out) {
        out["left_out"].push_back({{"study", study.study->name}, {"reason", study.reason}});
    }
    out["glare"] = json_of(report.glare);
    if (report.choice) {
        out["choice"] = json_of(*report.choice);
    }
    for (const SavingRow& row : report.savings) {
        out["leaving_out"].push_back({{"stage", row.name},
                                      {"forced", json_of(row.forced)},
                                      {"usual", json_of(row.usual)},
                                      {"largest_difference", number(row.largest)},
                                      {"bound", row.bound}});
    }
    for (const Growth& growth : report.growth) {
        out["growth"].push_back(json_of(growth));
    }
    return out.dump(2, ' ', true, ordered_json::error_handler_t::replace) + "\n";
}

std::string to_csv(const RendererReport& report) {
    std::vector<std::string> head{"study", "input", "width", "height", "variant", "usual"};
    for (const RowMetric& metric : row_metrics()) {
        head.emplace_back(metric.name);
    }
    for (const char* name : {"ms low 95", "ms high 95", "device", "is a CPU", "on front"}) {
        head.emplace_back(name);
    }
    std::string out = csv_line(head);
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const Row& row = report.rows[i];
        std::vector<std::string> words{
            std::string(row.study->name),    row.input,   std::to_string(row.size.width),
            std::to_string(row.size.height), row.variant, row.is_usual ? "1" : "0"};
        for (const RowMetric& metric : row_metrics()) {
            const std::optional<double> value = metric.of(row);
            words.push_back(value ? fmt::format("{:.9g}", *value) : "");
        }
        words.push_back(fmt::format("{:.6g}", 1e3 * row.time.low));
        words.push_back(fmt::format("{:.6g}", 1e3 * row.time.high));
        words.push_back(report.device);
        words.emplace_back(report.is_cpu ? "1" : "0");
        words.emplace_back(is_on_front(row, i) ? "1" : "0");
        out += csv_line(words);
    }
    return out;
}

} // namespace preview::report
