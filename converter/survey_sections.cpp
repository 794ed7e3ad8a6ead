#include "converter/survey_sections.h"

#include "converter/report.h"
#include "lutlib/plot/page.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
namespace {

using plot::number_cell;
using plot::text_cell;
using Rows = std::vector<std::vector<plot::Cell>>;

std::string section(const std::string& title, const std::string& words,
                    const std::vector<std::string>& columns, const Rows& rows) {
    return "<h2>" + title + "</h2>\n<p>" + words + "</p>\n" + plot::table_html(columns, rows);
}

std::string precision_section(const std::vector<lutlib::PrecisionRow>& precision) {
    Rows rows;
    for (const lutlib::PrecisionRow& row : precision) {
        rows.push_back({text_cell(row.lookup), text_cell(row.storage), text_cell(row.arithmetic),
                        number_cell(row.ulp.p99), number_cell(row.ulp.mean),
                        number_cell(row.ulp.max), number_cell(row.delta_e.p99),
                        number_cell(row.delta_e.mean), number_cell(row.delta_e.max)});
    }
    return section(
        "Precision",
        fmt::format("Nodes as they are stored, and the arithmetic of reading them, every "
                    "operation rounded; against the same lattice of {} nodes in double. "
                    "ulp: last places of a float of the result, of 2<sup>-10</sup> at "
                    "least.",
                    lutlib::precision_size),
        {"lookup", "storage", "arithmetic", "ulp p99", "ulp mean", "ulp max", "dE2000 p99",
         "dE2000 mean", "dE2000 max"},
        rows);
}

std::string sensitivity_section(const std::vector<lutlib::SensitivityRow>& sensitivity) {
    Rows rows;
    for (const lutlib::SensitivityRow& row : sensitivity) {
        rows.push_back({number_cell(row.bits), number_cell(row.p50), number_cell(row.delta_e.p99),
                        number_cell(row.delta_e.mean), number_cell(row.delta_e.max)});
    }
    return section("Half a code of the input",
                   "What half a code more or less in every channel does to the exact look, of the "
                   "eight ways the worst.",
                   {"bits", "dE2000 p50", "dE2000 p99", "dE2000 mean", "dE2000 largest seen"},
                   rows);
}

std::string noise_section(const std::vector<lutlib::NoiseRow>& noise) {
    Rows rows;
    for (const lutlib::NoiseRow& row : noise) {
        rows.push_back({number_cell(row.light), number_cell(255 * row.in),
                        number_cell(255 * row.out), number_cell(row.gain),
                        number_cell(row.delta_e)});
    }
    return section("A camera's noise along the greys",
                   fmt::format("Shot noise of {:g} electrons at light 1 and {:g} electrons of read "
                               "noise, independent in each channel, through the exact look. "
                               "Deviations in codes of 8 bits, of the noisiest channel.",
                               lutlib::camera_electrons, lutlib::camera_read_noise),
                   {"light", "in", "out", "gain", "mean dE2000"}, rows);
}

std::string chain_section(const std::vector<lutlib::ChainRow>& chains) {
    Rows rows;
    for (const lutlib::ChainRow& row : chains) {
        rows.push_back({text_cell(row.what), text_cell(row.between), number_cell(row.delta_e.p99),
                        number_cell(row.delta_e.mean), number_cell(row.delta_e.max)});
    }
    return section("One look after another",
                   fmt::format("The look's lattice of {} nodes in floats, tetrahedral, several "
                               "times, with results kept in between; against the exact look as "
                               "often, and the inverse against what went in.",
                               lutlib::precision_size),
                   {"chain", "in between", "dE2000 p99", "dE2000 mean", "dE2000 largest seen"},
                   rows);
}

} // namespace

std::vector<std::string> strain_sections(const lutlib::Strain& strain) {
    std::vector<std::string> out{precision_section(strain.precision),
                                 sensitivity_section(strain.sensitivity)};
    if (!strain.noise.empty()) {
        out.push_back(noise_section(strain.noise));
    }
    if (!strain.chains.empty()) {
        out.push_back(chain_section(strain.chains));
    }
    return out;
}

nlohmann::ordered_json strain_json(const lutlib::Strain& strain) {
    nlohmann::ordered_json out;
    for (const lutlib::PrecisionRow& row : strain.precision) {
        out["precision"].push_back({{"lookup", row.lookup},
                                    {"storage", row.storage},
                                    {"arithmetic", row.arithmetic},
                                    {"ulp", to_json(row.ulp)},
                                    {"delta_e_2000", to_json(row.delta_e)}});
    }
    for (const lutlib::SensitivityRow& row : strain.sensitivity) {
        out["half_a_code"].push_back(
            {{"bits", row.bits}, {"p50", row.p50}, {"delta_e_2000", to_json(row.delta_e)}});
    }
    for (const lutlib::NoiseRow& row : strain.noise) {
        out["noise"].push_back({{"light", row.light},
                                {"in", row.in},
                                {"out", row.out},
                                {"gain", row.gain},
                                {"mean_delta_e_2000", row.delta_e}});
    }
    for (const lutlib::ChainRow& row : strain.chains) {
        out["chains"].push_back({{"chain", row.what},
                                 {"between", row.between},
                                 {"delta_e_2000", to_json(row.delta_e)}});
    }
    return out;
}

} // namespace converter
