#include "converter/report.h"

#include "lutlib/error.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdio>
#include <system_error>

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
    if (output == lutlib::io::standard_stream) {
        std::fputs(text.c_str(), stderr);
    } else if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
        throw lutlib::Error("cannot write standard output: " +
                            std::generic_category().message(errno));
    }
}

void print(const nlohmann::ordered_json& json, const std::string& output) {
    print(json.dump(2) + "\n", output);
}

} // namespace converter
