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
namespace {

std::string escaped(std::string_view text, char kept) {
    std::string out;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if ((code >= 0x20 && code != 0x7f) || c == kept) {
            out += c;
        } else if (c == '\n' || c == '\r' || c == '\t') {
            out += c == '\n' ? "\\n" : c == '\r' ? "\\r" : "\\t";
        } else {
            out += fmt::format("\\x{:02x}", code);
        }
    }
    return out;
}

void put(const std::string& text, const std::string& output) {
    if (output == lutlib::io::standard_stream) {
        std::fputs(text.c_str(), stderr);
    } else if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
        throw lutlib::Error("cannot write standard output: " +
                            std::generic_category().message(errno));
    }
}

} // namespace

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
    return escaped(text, ' ');
}

std::string input_text(const std::string& path) {
    return one_line(lutlib::io::input_name(path));
}

std::string output_text(const std::string& path) {
    return one_line(lutlib::io::output_name(path));
}

std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void print(const std::string& text, const std::string& output) {
    put(escaped(text, '\n'), output);
}

void print(const nlohmann::ordered_json& json, const std::string& output) {
    put(json_text(json), output);
}

} // namespace converter
