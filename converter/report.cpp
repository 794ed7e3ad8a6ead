#include "converter/report.h"

#include "converter/quiet.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/io/terminal.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
nlohmann::ordered_json to_json(const lutlib::ErrorStats& stats) {
    nlohmann::ordered_json out{{"p99", stats.p99},
                               {"mean", stats.mean},
                               {"p95", stats.p95},
                               {"count", stats.count},
                               {"max", stats.max}};
    if (stats.at) {
        out["at"] = {stats.at->r, stats.at->g, stats.at->b};
        out["largest_seen"] = stats.largest_seen;
    }
    return out;
}

nlohmann::ordered_json to_json(const lutlib::Viewing& viewing) {
    return {{"output", viewing.output.name()}, {"reference_white", viewing.reference_white}};
}

std::string to_text(const lutlib::ErrorStats& stats) {
    return lutlib::io::figures_text(stats);
}

std::string loss_text(const lutlib::Loss& loss) {
    return fmt::format("{}: {:.4g}{}{}", loss.what, loss.figure, loss.unit.empty() ? "" : " ",
                       loss.unit);
}

std::string one_line(std::string_view text) {
    return lutlib::io::shown_text(text);
}

std::string input_text(const std::string& path) {
    return one_line(lutlib::io::input_name(path));
}

std::string output_text(const std::string& path) {
    return one_line(lutlib::io::output_name(path));
}

std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

namespace {

void print_now(const std::string& text, const std::string& output) {
    output == lutlib::io::standard_stream ? lutlib::io::print_err(text)
                                          : lutlib::io::print_out(text);
}

} // namespace

void print(const std::string& text, const std::string& output) {
    if (!is_quiet() || text.starts_with("lutconv: ")) { // a warning
        print_now(text, output);
    }
}

void print(const nlohmann::ordered_json& json, const std::string& output) {
    print_now(json_text(json), output);
}

} // namespace converter
