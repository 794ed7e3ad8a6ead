#include "converter/survey_panels.h"

#include "converter/survey_columns.h"
#include "lutlib/codes.h"
#include "lutlib/plot/heat_map.h"
#include "lutlib/plot/lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace converter {
namespace {

using lutlib::Details;
using lutlib::RgbD;
using lutlib::Survey;
using lutlib::SurveyRow;

std::string letters_of(const std::vector<double>& errors) {
    std::string out;
    for (const double error : errors) {
        out += plot::error_letter(error);
    }
    return out;
}

std::string letters_of(const std::vector<RgbD>& colors) {
    std::string out;
    for (const RgbD& c : colors) {
        for (std::size_t k = 0; k < 3; ++k) {
            out += plot::share_letter(c[k]);
        }
    }
    return out;
}

std::string css(RgbD srgb) {
    const auto code = [](double x) { return int{lutlib::CodeDepth{8}.code(x)}; };
    return fmt::format("#{:02x}{:02x}{:02x}", code(srgb.r), code(srgb.g), code(srgb.b));
}

std::string error_text(double error) {
    return error < 0.005 ? "0" : fmt::format("{:.{}f}", error, error < 9.95 ? 2 : 0);
}

plot::Lines ecdf(const std::vector<std::pair<double, double>>& points) {
    plot::Lines out;
    out.title = "Share of colours with no larger error";
    out.x_label = "dE2000";
    out.y_is_share = true;
    out.x_low = 1e-3;
    out.x_high = 100;
    out.first_line_id = "d-ecdf";
    out.lines = {{"", "the distribution of dE2000", 2, false, false, points}};
    return out;
}

std::vector<std::pair<double, double>> ecdf_points(const Details& details) {
    std::vector<std::pair<double, double>> out;
    for (std::size_t i = 0; i < details.shares.size(); ++i) {
        out.emplace_back(std::max(details.shares[i], 1e-3), lutlib::detail_shares[i]);
    }
    return out;
}

std::string title_of(const SurveyRow& row) {
    const auto& e = row.error.delta_e_2000;
    return fmt::format("{}: dE2000 p99 {:.3g}, mean {:.3g}, max {:.3g}", to_text(row.what), e.p99,
                       e.mean, e.max);
}

std::string worst_text(const Details& d) {
    return fmt::format("dE2000 {:.3g} at {:.4g} {:.4g} {:.4g}, in cell {} {} {}", d.worst_error,
                       d.worst.r, d.worst.g, d.worst.b, d.worst_cell[0], d.worst_cell[1],
                       d.worst_cell[2]);
}

// A row's values, in the order of panel_values().
std::vector<std::string> values_of(const Survey& survey, std::size_t row) {
    const Details& d = survey.details[row];
    std::vector<std::string> out{title_of(survey.rows[row]),
                                 plot::share_path(ecdf({}), ecdf_points(d)), worst_text(d),
                                 letters_of(d.near_worst)};
    for (const auto& plane : d.planes) {
        out.push_back(letters_of(plane));
    }
    for (const auto& gradient : d.after) {
        out.push_back(letters_of(gradient));
    }
    for (const double error : d.patches) {
        out.push_back(error_text(error));
    }
    return out;
}

std::vector<plot::Panels::Value> panel_values(const lutlib::DetailColors& colors) {
    std::vector<plot::Panels::Value> out{
        {"title", "text"}, {"ecdf", "path"}, {"worst", "text"}, {"near", "cells"}};
    for (const lutlib::DetailPlane& plane : colors.planes) {
        out.push_back({plane.name, "cells"});
    }
    for (const int bits : lutlib::gradient_bits) {
        out.push_back({fmt::format("after{}", bits), "bands"});
    }
    for (std::size_t i = 0; i < colors.patches.size(); ++i) {
        out.push_back({fmt::format("p{}", i), "text"});
    }
    return out;
}

std::string maps_html(const lutlib::DetailColors& colors, const Details& d) {
    std::string out = "<div class=\"panels\">\n";
    for (std::size_t i = 0; i < colors.planes.size(); ++i) {
        const lutlib::DetailPlane& plane = colors.planes[i];
        out += svg(plot::HeatMap{.id = "d-" + plane.name,
                                 .title = plane.title,
                                 .x_label = plane.x_label,
                                 .y_label = plane.y_label,
                                 .columns = lutlib::plane_cells,
                                 .rows = lutlib::plane_cells,
                                 .levels = letters_of(d.planes[i])});
    }
    out += svg(plot::HeatMap{.id = "d-near",
                             .title = "the worst cell and its neighbours",
                             .x_label = "red",
                             .y_label = "green",
                             .columns = lutlib::near_cells,
                             .rows = lutlib::near_cells,
                             .levels = letters_of(d.near_worst),
                             .lines_every = lutlib::cell_parts});
    return out + "</div>\n";
}

std::string patches_html(const lutlib::DetailColors& colors, const Details& d) {
    std::string out, group;
    for (std::size_t i = 0; i < colors.patches.size(); ++i) {
        const lutlib::DetailPatch& patch = colors.patches[i];
        if (patch.group != group) {
            out += (group.empty() ? "" : "</div>\n") + ("<h3>" + patch.group) +
                   ": dE2000 of each</h3><div class=\"patches\">\n";
            group = patch.group;
        }
        out += fmt::format("<div class=\"patch\"><i style=\"background:{}\"></i><b id=\"d-p{}\">{}"
                           "</b>{}</div>\n",
                           css(patch.srgb), i, error_text(d.patches[i]), plot::escaped(patch.name));
    }
    return out + "</div>\n";
}

std::string gradients_html(const lutlib::DetailColors& colors, const Details& d) {
    std::string out = fmt::format(
        "<h3>A grey gradient's errors, {:g} times enlarged about grey: what codes of so many bits "
        "do to the exact look, and what they and the combination do</h3>\n<div class=\"bands\">\n",
        lutlib::gradient_magnification);
    out += svg(plot::Band{"d-gradient", "the look itself", letters_of(colors.gradient)});
    for (std::size_t k = 0; k < lutlib::gradient_bits.size(); ++k) {
        const int bits = lutlib::gradient_bits[k];
        out += svg(plot::Band{fmt::format("d-before{}", bits), fmt::format("{} bits: codes", bits),
                              letters_of(colors.before[k])});
        out +=
            svg(plot::Band{fmt::format("d-after{}", bits),
                           fmt::format("{} bits: this combination", bits), letters_of(d.after[k])});
    }
    return out + "</div>\n";
}

} // namespace

plot::Panels survey_panels(const Survey& survey) {
    plot::Panels out;
    if (survey.details.empty()) {
        return out;
    }
    const std::size_t shown = survey.recommendation.row;
    const Details& d = survey.details[shown];
    const lutlib::DetailColors& colors = survey.detail_colors;
    out.values = panel_values(colors);
    for (std::size_t row = 0; row < survey.rows.size(); ++row) {
        out.rows.push_back(values_of(survey, row));
    }
    out.markup =
        fmt::format("<h2 id=\"chosen\">Where it errs: <span id=\"d-title\">{}</span></h2>\n"
                    "<p class=\"only\">Click a mark or a row to see another.</p>\n",
                    plot::escaped(title_of(survey.rows[shown]))) +
        maps_html(colors, d) + "<div class=\"panels\"><div class=\"share\">" +
        svg(ecdf(ecdf_points(d))) + "</div><div>" + plot::heat_legend("dE2000") +
        fmt::format("<p>Worst colour: <span id=\"d-worst\">{}</span></p>", worst_text(d)) +
        "</div></div>\n" + patches_html(colors, d) + gradients_html(colors, d);
    return out;
}

} // namespace converter
