#include "preview/panels/curve_canvas.h"

#include "lutlib/color/oklab.h"
#include "lutlib/color/transfer.h"
#include "preview/finish/curve_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace preview::panels {

namespace {

using lutlib::Knot;
using lutlib::Knots;
using lutlib::Parameter;

constexpr int ribbon_steps = 72;

/// Curves of a channel, and those that share a plot over hue, by their names; others are white.
struct OwnColor {
    std::string_view name;
    int r, g, b;
};
constexpr std::array<OwnColor, 6> own_colors{{
    {"red", 255, 96, 88},
    {"green", 96, 224, 104},
    {"blue", 112, 152, 255},
    {"hue-vs-hue", 255, 150, 255},
    {"hue-vs-sat", 255, 214, 80},
    {"hue-vs-lum", 255, 255, 255},
}};

/// Dimmed curves over a ribbon of hues keep their colours apart from it.
constexpr int edited_opacity = 240, dimmed_opacity = 150, dimmed_on_dark = 120;

} // namespace

ImU32 curve_color(const Parameter& parameter, int opacity) {
    for (const OwnColor& row : own_colors) {
        if (row.name == parameter.name) {
            return IM_COL32(row.r, row.g, row.b, opacity);
        }
    }
    return IM_COL32(255, 255, 255, opacity);
}

namespace {

/// A display colour of that hue, at a lightness and chroma that sRGB holds at every hue.
ImU32 hue_color(double dial, float alpha) {
    constexpr double lightness = 0.72, chroma = 0.12;
    const double angle = lutlib::oklab_hue(dial) * M_PI / 180;
    const lutlib::RgbD linear =
        lutlib::linear_from_oklab({lightness, chroma * std::cos(angle), chroma * std::sin(angle)});
    const auto code = [](double light) {
        return static_cast<float>(lutlib::srgb_encode(lutlib::saturate(light)));
    };
    return ImGui::ColorConvertFloat4ToU32({code(linear.r), code(linear.g), code(linear.b), alpha});
}

void draw_ribbon(ImDrawList& list, const Canvas& canvas) {
    const float step = canvas.size.x / ribbon_steps;
    for (int i = 0; i < ribbon_steps; ++i) {
        const float left = canvas.origin.x + step * static_cast<float>(i);
        const ImU32 from = hue_color(360.0 * i / ribbon_steps, 0.45F);
        const ImU32 to = hue_color(360.0 * (i + 1) / ribbon_steps, 0.45F);
        list.AddRectFilledMultiColor({left, canvas.origin.y},
                                     {left + step, canvas.origin.y + canvas.size.y}, from, to, to,
                                     from);
    }
}

void draw_grid(ImDrawList& list, const Canvas& canvas, const Parameter& parameter) {
    const ImU32 line = IM_COL32(255, 255, 255, 28);
    for (int i = 1; i < 4; ++i) {
        const float share = static_cast<float>(i) / 4;
        const float x = canvas.origin.x + share * canvas.size.x;
        const float y = canvas.origin.y + share * canvas.size.y;
        list.AddLine({x, canvas.origin.y}, {x, canvas.origin.y + canvas.size.y}, line);
        list.AddLine({canvas.origin.x, y}, {canvas.origin.x + canvas.size.x, y}, line);
    }
    const double low = canvas.view.x_min, high = canvas.view.x_max;
    const bool is_diagonal = parameter.axis.diagonal;
    list.AddLine(canvas.at({low, is_diagonal ? low : parameter.fallback}),
                 canvas.at({high, is_diagonal ? high : parameter.fallback}),
                 IM_COL32(255, 255, 255, 90), em(0.07F));
}

/// How often the picture has the values of the axis, behind the curve that will act on them. The
/// square root of the counts: rare values still show beside frequent ones.
void draw_counts(ImDrawList& list, const Canvas& canvas, const Parameter& parameter,
                 const std::vector<std::uint32_t>& counts) {
    const CountedAxis* const axis = axis_for(parameter);
    if (axis == nullptr || counts.size() != counted_axes.size() * axis_bins) {
        return;
    }
    const auto row = static_cast<std::size_t>(axis - counted_axes.data());
    const std::uint32_t* const bins = &counts[row * axis_bins];
    // The outermost bins of an open axis hold what is clipped and would dwarf the others.
    const std::size_t ends = parameter.axis.periodic ? 0 : 1;
    const std::uint32_t most = *std::max_element(bins + ends, bins + axis_bins - ends);
    if (most == 0) {
        return;
    }
    const double step = (axis->max - axis->min) / axis_bins;
    const double first = parameter.axis.periodic ? -step / 2 : 0; // bins about their hues
    const float floor_y = canvas.origin.y + canvas.size.y;
    const ImU32 color =
        parameter.axis.periodic ? IM_COL32(0, 0, 0, 110) : IM_COL32(205, 205, 205, 62);
    for (std::uint32_t i = 0; i < axis_bins; ++i) {
        const float share =
            std::min(std::sqrt(static_cast<float>(bins[i]) / static_cast<float>(most)), 1.0F);
        const double x = axis->min + first + step * i;
        const float left = canvas.at({x, 0}).x, right = canvas.at({x + step, 0}).x;
        list.AddRectFilled({left, floor_y - 0.94F * share * canvas.size.y}, {right, floor_y},
                           color);
    }
}

std::string lowered(std::string_view text) {
    std::string out(text);
    if (!out.empty()) {
        out[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(out[0])));
    }
    return out;
}

std::string with_unit(const std::string& name, std::string_view unit) {
    return unit.empty() ? name : name + " (" + std::string(unit) + ")";
}

} // namespace

ImVec2 Canvas::at(Knot knot) const {
    return {
        origin.x + size.x * static_cast<float>((knot.x - view.x_min) / (view.x_max - view.x_min)),
        origin.y + size.y * static_cast<float>((view.y_max - knot.y) / (view.y_max - view.y_min))};
}

Knot Canvas::knot(ImVec2 place) const {
    return {view.x_min +
                static_cast<double>((place.x - origin.x) / size.x) * (view.x_max - view.x_min),
            view.y_max -
                static_cast<double>((place.y - origin.y) / size.y) * (view.y_max - view.y_min)};
}

void draw_backdrop(const Ui& ui, const Canvas& canvas, const Parameter& parameter) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(canvas.origin,
                       {canvas.origin.x + canvas.size.x, canvas.origin.y + canvas.size.y},
                       IM_COL32(38, 38, 38, 255));
    if (parameter.axis.periodic) {
        draw_ribbon(list, canvas);
    }
    draw_counts(list, canvas, parameter, ui.facts.measured.axis_counts);
    draw_grid(list, canvas, parameter);
}

void draw_curve(const Canvas& canvas, const Parameter& parameter, const Knots& knots,
                bool is_edited) {
    std::vector<ImVec2> points;
    const auto steps = static_cast<int>(canvas.size.x / 2);
    const bool neutral_diagonal = knots.empty() && parameter.axis.diagonal;
    const lutlib::Curve curve = lutlib::curve_of(parameter, knots);
    for (int i = 0; i <= steps; ++i) {
        const double x =
            canvas.view.x_min + (canvas.view.x_max - canvas.view.x_min) * i / std::max(steps, 1);
        points.push_back(canvas.at({x, neutral_diagonal ? x : curve(x)}));
    }
    const int opacity = is_edited                 ? edited_opacity
                        : parameter.axis.periodic ? dimmed_opacity
                                                  : dimmed_on_dark;
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()),
                                            curve_color(parameter, opacity), 0,
                                            is_edited ? 1.8F : 1.2F);
}

void draw_knots(const Canvas& canvas, const Knots& knots, std::optional<std::size_t> lit) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const ImVec2 place = canvas.at(knots[i]);
        list.AddCircleFilled(place, em(knot_radius), IM_COL32(20, 20, 24, 255));
        list.AddCircle(place, em(knot_radius),
                       lit == i ? IM_COL32(255, 190, 60, 255) : IM_COL32(255, 255, 255, 255), 0,
                       1.8F);
    }
}

std::string name_of_x(const Parameter& parameter) {
    return std::string(parameter.axis.label);
}

std::string name_of_y(const Parameter& parameter) {
    return parameter.axis.diagonal ? "output" : lowered(parameter.label);
}

void draw_axis_names(const Canvas& canvas, const Parameter& parameter) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = IM_COL32(235, 235, 235, 255), shade = IM_COL32(0, 0, 0, 170);
    const auto text = [&](ImVec2 at, const std::string& words) {
        list.AddText({at.x + 1, at.y + 1}, shade, words.c_str());
        list.AddText(at, color, words.c_str());
    };
    const float left = canvas.origin.x + em(0.3F), line = ImGui::GetTextLineHeight();
    const std::string y_unit = name_of_y(parameter) == lowered(parameter.unit)
                                   ? std::string()
                                   : std::string(parameter.unit);
    text({left, canvas.origin.y},
         fmt::format("{:.4g}  {}", canvas.view.y_max, with_unit(name_of_y(parameter), y_unit)));
    const float below = canvas.origin.y + canvas.size.y;
    text({left, below - line}, fmt::format("{:.4g}", canvas.view.y_min));
    const std::string low = fmt::format("{:.4g}", canvas.view.x_min);
    const std::string high = fmt::format("{:.4g}", canvas.view.x_max);
    const std::string name = with_unit(name_of_x(parameter), parameter.axis.unit);
    text({canvas.origin.x, below}, low);
    text({canvas.origin.x + (canvas.size.x - ImGui::CalcTextSize(name.c_str()).x) / 2, below},
         name);
    text({canvas.origin.x + canvas.size.x - ImGui::CalcTextSize(high.c_str()).x, below}, high);
}

} // namespace preview::panels
