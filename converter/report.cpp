#include "converter/report.h"

#include "lutlib/io/bake_report.h"

#include "lutlib/io/file.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace converter {

nlohmann::ordered_json to_json(const lutlib::ErrorStats& stats) {
    return {{"max", stats.max},
            {"p99", stats.p99},
            {"p95", stats.p95},
            {"mean", stats.mean},
            {"count", stats.count}};
}

std::string to_text(const lutlib::ErrorStats& stats) {
    return lutlib::io::figures_text(stats);
}

std::string loss_text(const lutlib::Loss& loss) {
    return fmt::format("{}: {:.4g}{}{}", loss.what, loss.figure, loss.unit.empty() ? "" : " ",
                       loss.unit);
}

void print(const std::string& text, const std::string& output) {
    std::FILE* const stream = output == lutlib::io::standard_stream ? stderr : stdout;
    std::fputs(text.c_str(), stream);
}

void print(const nlohmann::ordered_json& json, const std::string& output) {
    print(json.dump(2) + "\n", output);
}

} // namespace converter
