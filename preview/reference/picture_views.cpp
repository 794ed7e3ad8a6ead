#include "preview/reference/picture_views.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string_view>

namespace preview::reference {

namespace {

using lutlib::RgbD;

constexpr double half_code = 0.5 / 255;

/// NaN becomes 0.
double within(double v) {
    return v > 0 ? std::min(v, 1.0) : 0.0;
}

RgbD within(const RgbD& c) {
    return {within(c.r), within(c.g), within(c.b)};
}

double luma(const RgbD& c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

RgbD grey(double v) {
    return {v, v, v};
}

RgbD color_of(const std::array<float, 3>& color) {
    return {color[0], color[1], color[2]};
}

RgbD levels(const Viewed& v) {
    const double level = within(luma(within(v.color)));
    const auto band = std::find_if(level_bands.begin(), level_bands.end(),
                                   [&](const LevelBand& row) { return level < row.to; });
    return band->text.empty() ? grey(level) : color_of(band->color);
}

RgbD stripes(const Viewed& v) {
    const RgbD color = within(v.color);
    return luma(color) >= v.level ? grey((v.x + v.y) / (3 * v.unit) % 2) : color;
}

bool any(const RgbD& c, const std::function<bool(double)>& holds) {
    return holds(c.r) || holds(c.g) || holds(c.b);
}

bool is_white(double v) {
    return v >= 1 - half_code;
}

bool is_black(double v) {
    return v <= half_code;
}

bool is_beyond(double v) {
    return v > 1 + half_code || v < -half_code;
}

RgbD mark(std::string_view view, std::size_t entry) {
    return color_of(picture_view_named(view)->legend[entry].color);
}

RgbD clipped(const Viewed& v) {
    if (any(v.color, is_white)) {
        return mark("clipping", any(v.before, is_white) ? 0 : 1);
    }
    if (any(v.color, is_black)) {
        return mark("clipping", any(v.before, is_black) ? 2 : 3);
    }
    return v.color;
}

RgbD outside(const Viewed& v) {
    if (any(v.color, is_beyond)) {
        return mark("gamut", any(v.before, is_beyond) ? 0 : 1);
    }
    return grey(0.5 * within(luma(within(v.color))));
}

RgbD hsv_saturation(const Viewed& v) {
    const RgbD c = within(v.color);
    const double most = std::max({c.r, c.g, c.b}), least = std::min({c.r, c.g, c.b});
    return grey(most > 0 ? (most - least) / most : 0);
}

const std::map<std::string_view, RgbD (*)(const Viewed&)>& twins() {
    static const std::map<std::string_view, RgbD (*)(const Viewed&)> table{
        {"picture", [](const Viewed& v) { return v.color; }},
        {"false-color", &levels},
        {"zebra", &stripes},
        {"clipping", &clipped},
        {"gamut", &outside},
        {"red", [](const Viewed& v) { return grey(v.color.r); }},
        {"green", [](const Viewed& v) { return grey(v.color.g); }},
        {"blue", [](const Viewed& v) { return grey(v.color.b); }},
        {"luma", [](const Viewed& v) { return grey(luma(within(v.color))); }},
        {"saturation", &hsv_saturation},
    };
    return table;
}

} // namespace

RgbD picture_view(const PictureView& row, const Viewed& viewed) {
    return within(twins().at(row.name)(viewed));
}

} // namespace preview::reference
