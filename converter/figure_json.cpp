#include "converter/figure_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace converter {
namespace {

using Json = nlohmann::ordered_json;

Json number_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json shown_color_json(const lutlib::RgbD& srgb) {
    Json out = Json::array();
    for (std::size_t c = 0; c < 3; ++c) {
        constexpr double digits = 1e6;
        const double rounded = std::round(srgb[c] * digits) / digits;
        out.push_back(number_json(std::isfinite(rounded) ? rounded : srgb[c]));
    }
    return out;
}

// Null for what only stands in a legend.
Json line_json(const plot::Line& line) {
    if (line.points.empty() && line.label.empty()) {
        return nullptr;
    }
    Json points = Json::array();
    for (const auto& [x, y] : line.points) {
        points.push_back({number_json(x), number_json(y)});
    }
    return {{"name", line.label.empty() ? line.name : line.label}, {"points", std::move(points)}};
}

Json cells_json(const plot::Cells& cells) {
    Json colors = Json::array();
    for (const lutlib::RgbD& color : cells.colors) {
        colors.push_back(shown_color_json(color));
    }
    Json out{{"name", cells.name}, {"columns", cells.columns}, {"rows", cells.rows}};
    if (!cells.labels.empty()) {
        out["labels"] = cells.labels;
    }
    out["srgb"] = std::move(colors);
    return out;
}

Json dots_json(const plot::Dots& dots) {
    Json places = Json::array(), colors = Json::array();
    for (const plot::Dot& dot : dots.dots) {
        places.push_back({number_json(dot.x), number_json(dot.y)});
        colors.push_back(shown_color_json(dot.color));
    }
    return {{"name", dots.name}, {"places", std::move(places)}, {"srgb", std::move(colors)}};
}

template <class Items>
void add_all(Json& out, const char* name, const Items& items,
             Json (*to_json)(const typename Items::value_type& item)) {
    if (items.empty()) {
        return;
    }
    out[name] = Json::array();
    for (const auto& item : items) {
        if (Json one = to_json(item); !one.is_null()) {
            out[name].push_back(std::move(one));
        }
    }
}

} // namespace

nlohmann::ordered_json to_json(const plot::Figure& figure) {
    Json out{{"title", figure.title}, {"x", figure.x.label}, {"y", figure.y.label}};
    add_all(out, "lines", figure.lines, line_json);
    add_all(out, "cells", figure.cells, cells_json);
    add_all(out, "dots", figure.dots, dots_json);
    add_all(out, "notes", figure.notes, [](const plot::Note& note) -> Json {
        return {{"x", note.x}, {"y", note.y}, {"text", note.text}};
    });
    return out;
}

} // namespace converter
