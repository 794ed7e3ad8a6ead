#include "converter/gpu_times.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/named.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace converter {
namespace {

// What preview_bench times, as combinations of a survey.
struct BenchLookup {
    std::string_view name;
    int size;
    std::string_view storage, lookup;
};
constexpr std::array<BenchLookup, 10> bench_lookups{{
    {"strip", 33, "8", "trilinear"},
    {"strip-bilinear", 33, "8", "hardware"},
    {"volume", 33, "float", "hardware"},
    {"nearest", 33, "float", "nearest"},
    {"trilinear", 33, "float", "trilinear"},
    {"tetrahedral", 33, "float", "tetrahedral"},
    {"shared-trilinear", 16, "8", "trilinear"},
    {"shared-trilinear, float", 16, "8", "trilinear"},
    {"shared-tetrahedral", 16, "8", "tetrahedral"},
    {"shared-tetrahedral, float", 16, "8", "tetrahedral"},
}};

std::optional<std::size_t> row_of(const lutlib::Survey& survey, const std::string& name) {
    const BenchLookup* const wanted = lutlib::find_named(bench_lookups, name);
    const auto found =
        std::find_if(survey.rows.begin(), survey.rows.end(), [&](const lutlib::SurveyRow& row) {
            return wanted && row.what.size == wanted->size && row.what.shaper->name == "none" &&
                   row.what.storage->name == wanted->storage &&
                   row.what.lookup->name == wanted->lookup && !row.what.fitted;
        });
    return found == survey.rows.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - survey.rows.begin()));
}

} // namespace

GpuTimes read_gpu_times(const std::string& path, const lutlib::Survey& survey) {
    constexpr std::string_view group = "lut, ";
    const std::string text = lutlib::io::read_file(path);
    const auto refuse = [&path](const std::string& why) {
        return lutlib::Error("give what preview_bench --json prints; this is something else: " +
                                 why,
                             {lutlib::io::input_name(path), 0, ""});
    };
    GpuTimes out;
    try {
        const auto json = nlohmann::json::parse(text);
        out.device = json.at("device").get<std::string>();
        out.pixels = json.at("width").get<double>() * json.at("height").get<double>();
        for (const nlohmann::json& row : json.at("rows")) {
            const auto of = row.at("group").get<std::string>();
            if (of.rfind(group, 0) == 0) {
                const auto name = row.at("name").get<std::string>();
                out.rows.push_back({name, of.substr(group.size()),
                                    row.at("median_ms").get<double>(),
                                    row.at("ratio_to_copy").get<double>(), row_of(survey, name)});
            }
        }
    } catch (const nlohmann::json::exception& error) {
        throw refuse(error.what());
    }
    if (out.rows.empty() || !(out.pixels > 0)) {
        throw refuse("no lookup was timed");
    }
    return out;
}

nlohmann::ordered_json to_json(const GpuTimes& times) {
    nlohmann::ordered_json out{{"device", times.device}, {"pixels", times.pixels}};
    for (const GpuTime& time : times.rows) {
        nlohmann::ordered_json row{{"lookup", time.lookup},
                                   {"formats", time.formats},
                                   {"milliseconds", time.milliseconds},
                                   {"ratio_to_copy", time.ratio_to_copy}};
        for (const Raster& raster : rasters) {
            row[std::string("milliseconds_") + raster.name] = times.milliseconds(time, raster);
        }
        row["row"] = time.row ? nlohmann::ordered_json(*time.row) : nlohmann::ordered_json();
        out["rows"].push_back(std::move(row));
    }
    return out;
}

} // namespace converter
