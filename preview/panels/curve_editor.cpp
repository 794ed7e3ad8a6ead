// The editor of one curve: click an empty place for a knot, drag it, press right to delete it.
#include "lutlib/color/oklab.h"
#include "lutlib/color/transfer.h"
#include "preview/editor/knots.h"
#include "preview/finish/curve_counts.h"
#include "preview/panels/ui.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace preview::panels {

namespace {

using lutlib::Knot;
using lutlib::Knots;
using lutlib::Parameter;

// In heights of the text.
constexpr float knot_radius = 0.36F;
constexpr float reach = 0.72F; // from which a knot is caught
constexpr int ribbon_steps = 72;

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

/// Maps between the view and the window's pixels.
struct Canvas {
    CurveView view;
    ImVec2 origin, size;

    ImVec2 at(Knot knot) const {
        return {origin.x +
                    size.x * static_cast<float>((knot.x - view.x_min) / (view.x_max - view.x_min)),
                origin.y +
                    size.y * static_cast<float>((view.y_max - knot.y) / (view.y_max - view.y_min))};
    }
    Knot knot(ImVec2 place) const {
        return {view.x_min +
                    static_cast<double>((place.x - origin.x) / size.x) * (view.x_max - view.x_min),
                view.y_max -
                    static_cast<double>((place.y - origin.y) / size.y) * (view.y_max - view.y_min)};
    }
    Knot reach_share() const {
        return {static_cast<double>(em(reach) / size.x), static_cast<double>(em(reach) / size.y)};
    }
};

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

void draw_grid(ImDrawList& list, const Canvas& canvas) {
    const ImU32 line = IM_COL32(255, 255, 255, 28);
    for (int i = 1; i < 4; ++i) {
        const float share = static_cast<float>(i) / 4;
        const float x = canvas.origin.x + share * canvas.size.x;
        const float y = canvas.origin.y + share * canvas.size.y;
        list.AddLine({x, canvas.origin.y}, {x, canvas.origin.y + canvas.size.y}, line);
        list.AddLine({canvas.origin.x, y}, {canvas.origin.x + canvas.size.x, y}, line);
    }
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

void draw_curve(ImDrawList& list, const Canvas& canvas, const Parameter& parameter,
                const Knots& knots) {
    std::vector<ImVec2> points;
    const auto steps = static_cast<int>(canvas.size.x / 2);
    const bool neutral_diagonal = knots.empty() && parameter.axis.diagonal;
    const lutlib::Curve curve = lutlib::curve_of(parameter, knots);
    for (int i = 0; i <= steps; ++i) {
        const double x =
            canvas.view.x_min + (canvas.view.x_max - canvas.view.x_min) * i / std::max(steps, 1);
        points.push_back(canvas.at({x, neutral_diagonal ? x : curve(x)}));
    }
    list.AddPolyline(points.data(), static_cast<int>(points.size()), IM_COL32(255, 255, 255, 230),
                     0, 1.8F);
}

void draw_knots(ImDrawList& list, const Canvas& canvas, const Knots& knots,
                std::optional<std::size_t> lit) {
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const ImVec2 place = canvas.at(knots[i]);
        list.AddCircleFilled(place, em(knot_radius), IM_COL32(20, 20, 24, 255));
        list.AddCircle(place, em(knot_radius),
                       lit == i ? IM_COL32(255, 190, 60, 255) : IM_COL32(255, 255, 255, 255), 0,
                       1.8F);
    }
}

/// What the mouse does to the knots: a click adds one or catches the one `under` it, to be dragged,
/// the right button removes it. Whether anything changed.
bool edit_knots(const Parameter& parameter, Knots& knots, const Knot& mouse, bool hovered,
                bool active, std::optional<std::size_t>& under,
                std::optional<std::size_t>& dragged) {
    bool changed = false;
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        dragged = under;
        if (!dragged) {
            dragged = add_knot(parameter, knots, mouse);
            changed = true;
        }
    } else if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && under) {
        remove_knot(parameter, knots, *under);
        under.reset();
        changed = true;
    } else if (active && dragged && *dragged < knots.size() &&
               ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
        move_knot(parameter, knots, *dragged, mouse);
        changed = true;
    }
    return changed;
}

void draw_curves(const Ui& ui, const Canvas& canvas, const Parameter& parameter, const Knots& knots,
                 ImVec2 origin, ImVec2 corner) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(origin, corner, IM_COL32(24, 24, 24, 255));
    list.PushClipRect(origin, corner, true);
    if (parameter.axis.periodic) {
        draw_ribbon(list, canvas);
    }
    draw_counts(list, canvas, parameter, ui.facts.measured.axis_counts);
    draw_grid(list, canvas);
    draw_curve(list, canvas, parameter, knots);
    list.PopClipRect();
}

} // namespace

bool curve_editor(Ui& ui, const Parameter& parameter, Knots& knots, const std::string& place) {
    // The knot that is dragged, and the view it is dragged in: one mouse, one drag.
    static std::optional<std::size_t> dragged;
    static CurveView dragged_view;

    ImGui::TextDisabled("%.*s against %.*s", static_cast<int>(parameter.label.size()),
                        parameter.label.data(), static_cast<int>(parameter.axis.label.size()),
                        parameter.axis.label.data());
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, em(4)),
                      std::floor(ImGui::GetFontSize() * 10));
    ImGui::PushID(place.c_str());
    ImGui::InvisibleButton("curve", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    ImGui::PopID();
    mark(ui, place);
    ui.shows_curves = ui.shows_curves || ImGui::IsItemVisible();
    const bool active = ImGui::IsItemActive();
    const bool hovered = ImGui::IsItemHovered();
    if (active && ImGui::IsItemActivated()) {
        dragged.reset();
        dragged_view = view_of(parameter, knots);
    }
    // A knot at either end is to be seen and caught whole.
    const Canvas canvas{active ? dragged_view : view_of(parameter, knots),
                        {origin.x + em(knot_radius), origin.y},
                        {size.x - 2 * em(knot_radius), size.y}};
    const ImGuiIO& io = ImGui::GetIO();
    const Knot mouse = canvas.knot(io.MousePos);
    std::optional<std::size_t> under;
    if (hovered || active) {
        under = knot_at(canvas.view, knots, mouse, canvas.reach_share());
    }

    const bool changed = edit_knots(parameter, knots, mouse, hovered, active, under, dragged);

    draw_curves(ui, canvas, parameter, knots, origin, {origin.x + size.x, origin.y + size.y});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_knots(list, canvas, knots, active ? dragged : under);
    if (hovered || active) {
        const Knot shown = active && dragged && *dragged < knots.size() ? knots[*dragged] : mouse;
        ImGui::SetTooltip("%.4g : %.4g\nclick: new knot, right: delete", shown.x, shown.y);
    }
    return changed;
}

} // namespace preview::panels
