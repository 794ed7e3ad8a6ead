#include "preview/panels/curve_editor.h"

#include "lutlib/error.h"
#include "preview/panels/curve_canvas.h"
#include "preview/panels/eyedropper.h"
#include "preview/panels/parameter_control.h"
#include "preview/panels/theme.h"
#include "preview/panels/tip.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace preview::panels {

namespace {

using lutlib::Knot;
using lutlib::Knots;
using lutlib::Parameter;

constexpr float key_length = 0.9F; // of a colour's line, in heights of the text
constexpr float reach = 0.72F;     // from which a knot is caught, in heights of the text

/// A place that the mouse has chosen, with no more digits than it can tell apart.
Knot rounded(const CurveView& view, const Knot& knot) {
    const auto round_to = [](double x, double span) {
        const double steps = std::pow(10, -std::floor(std::log10(span / 500)));
        return std::round(x * steps) / steps;
    };
    return {round_to(knot.x, view.x_max - view.x_min), round_to(knot.y, view.y_max - view.y_min)};
}

/// What the mouse does to the knots: a click adds one or catches the one `under` it, to be dragged,
/// the right button removes it. Whether anything changed.
bool edit_knots(const Parameter& parameter, Knots& knots, const Knot& mouse,
                std::optional<std::size_t>& under, std::optional<std::size_t>& dragged) {
    bool changed = false;
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        dragged = under;
        if (!dragged) {
            dragged = add_knot(parameter, knots, mouse);
            changed = true;
        }
    } else if (is_hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && under) {
        remove_knot(parameter, knots, *under);
        under.reset();
        dragged.reset();
        changed = true;
    } else if (ImGui::IsItemActive() && dragged && *dragged < knots.size() &&
               ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
        move_knot(parameter, knots, *dragged, mouse);
        changed = true;
    }
    return changed;
}

/// A line in the curve's colour: whose it is in the plot.
void color_key(const Parameter& curve) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float length = em(key_length), middle = at.y + ImGui::GetFrameHeight() / 2;
    ImGui::GetWindowDrawList()->AddLine({at.x, middle}, {at.x + length, middle},
                                        curve_color(curve, 255), em(0.2F));
    ImGui::Dummy({length, ImGui::GetFrameHeight()});
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
}

/// Where another curve is drawn in the plot of the edited one: at the same places of the axis, and
/// over its own heights where its range is another.
Canvas canvas_beside(const Canvas& edited, const Parameter& of_edited, const Parameter& other,
                     const Knots& knots) {
    Canvas out = edited;
    if (other.min != of_edited.min || other.max != of_edited.max ||
        other.fallback != of_edited.fallback) {
        const CurveView own = view_of(other, knots);
        out.view.y_min = own.y_min;
        out.view.y_max = own.y_max;
    }
    return out;
}

/// Which curve is edited, and which of the others are seen.
void choose_curve(Ui& ui, CurveUse& use, std::span<const Parameter> curves,
                  const std::string& place) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const float width = em(key_length) + 2 * ImGui::GetFrameHeight() +
                            3 * style.ItemInnerSpacing.x +
                            ImGui::CalcTextSize(curves[i].label.data()).x;
        if (i > 0 && ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right) {
            ImGui::SameLine();
        }
        ImGui::PushID(static_cast<int>(i));
        color_key(curves[i]);
        const std::string name(curves[i].name);
        if (ImGui::RadioButton(std::string(curves[i].label).c_str(), use.edited == i)) {
            use.edited = i;
            use.knot.reset();
            use.problem.clear();
        }
        mark(ui, place + "." + name + ".edit");
        tip("The curve that is edited; the others are seen beside it where they are ticked", {},
            false);
        bool is_seen = !use.hidden[i];
        ImGui::SameLine(0, style.ItemInnerSpacing.x);
        if (ImGui::Checkbox("##seen", &is_seen)) {
            use.hidden[i] = !is_seen;
        }
        mark(ui, place + "." + name + ".seen");
        tip("Seen beside the curve that is edited", {}, false);
        ImGui::PopID();
    }
}

/// The plot itself.
bool plot(Ui& ui, CurveUse& use, std::span<const Parameter> curves, std::span<lutlib::Value> values,
          const std::string& place) {
    // The view that a knot is dragged in: one mouse, one drag.
    static CurveView dragged_view;
    const Parameter& parameter = curves[use.edited];
    Knots& knots = std::get<Knots>(values[use.edited]);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float width = std::max(ImGui::GetContentRegionAvail().x, em(4));
    const float side = std::min(width, em(26));
    // Identity goes at 45 degrees.
    const ImVec2 size = parameter.axis.diagonal ? ImVec2(side, side) : ImVec2(width, em(13));
    ImGui::InvisibleButton("curve", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    mark(ui, place + "." + std::string(parameter.name));
    ui.shows_curves = ui.shows_curves || ImGui::IsItemVisible();
    const bool is_active = ImGui::IsItemActive(), is_hovered = ImGui::IsItemHovered();
    if (ImGui::IsItemActivated()) {
        use.knot.reset();
        dragged_view = view_of(parameter, knots);
    }
    // A knot at either end is to be seen and caught whole.
    const float edge = em(knot_radius);
    const Canvas canvas{is_active ? dragged_view : view_of(parameter, knots),
                        {origin.x + edge, origin.y + edge},
                        {size.x - 2 * edge, size.y - 2 * edge}};
    const Knot mouse = canvas.knot(ImGui::GetIO().MousePos);
    std::optional<std::size_t> under;
    if (is_hovered || is_active) {
        under = knot_at(canvas.view, knots, mouse,
                        {static_cast<double>(em(reach) / canvas.size.x),
                         static_cast<double>(em(reach) / canvas.size.y)});
    }
    const bool changed = edit_knots(parameter, knots, rounded(canvas.view, mouse), under, use.knot);

    draw_backdrop(ui, canvas, parameter);
    ImGui::PushClipRect(origin, {origin.x + size.x, origin.y + size.y}, true);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (i != use.edited && !use.hidden[i]) {
            const Knots& others = std::get<Knots>(values[i]);
            draw_curve(canvas_beside(canvas, parameter, curves[i], others), curves[i], others,
                       false);
        }
    }
    draw_curve(canvas, parameter, knots, true);
    draw_knots(canvas, knots, under && !is_active ? under : use.knot);
    ImGui::PopClipRect();
    draw_axis_names(canvas, parameter);
    ImGui::Dummy({size.x, ImGui::GetTextLineHeight()});
    if (is_hovered || is_active) {
        const Knot shown =
            use.knot && *use.knot < knots.size() && is_active ? knots[*use.knot] : mouse;
        ImGui::SetTooltip("%s %.4g, %s %.4g\nusually %s\nclick: new knot, right: delete",
                          name_of_x(parameter).c_str(), shown.x, name_of_y(parameter).c_str(),
                          shown.y, usual_text(parameter).c_str());
    }
    return changed;
}

/// The chosen knot's numbers.
bool knot_numbers(Ui& ui, CurveUse& use, const Parameter& parameter, Knots& knots,
                  const std::string& place) {
    if (!use.knot || *use.knot >= knots.size()) {
        ImGui::TextDisabled("click a knot to type its numbers");
        return false;
    }
    Knot knot = knots[*use.knot];
    const CurveView view = view_of(parameter, knots);
    const auto field = [&](const std::string& name, double& value, double span, double min,
                           double max, const std::string& mark_name) {
        ImGui::SetNextItemWidth(ImGui::GetContentRegionMax().x * 0.4F);
        const bool changed =
            ImGui::DragScalar(("##" + mark_name).c_str(), ImGuiDataType_Double, &value,
                              static_cast<float>(span / 500), &min, &max, (name + " %.5g").c_str(),
                              ImGuiSliderFlags_AlwaysClamp);
        mark(ui, mark_name);
        tip(name, {}, true);
        ImGui::SameLine();
        return changed;
    };
    bool changed = field(name_of_x(parameter), knot.x, view.x_max - view.x_min, parameter.axis.min,
                         parameter.axis.max, place + ".knot.x");
    changed |= field(name_of_y(parameter), knot.y, view.y_max - view.y_min, parameter.min,
                     parameter.max, place + ".knot.y");
    if (changed) {
        move_knot(parameter, knots, *use.knot, knot);
    }
    if (ImGui::Button("Delete")) {
        remove_knot(parameter, knots, *use.knot);
        use.knot.reset();
        changed = true;
    }
    mark(ui, place + ".knot.delete");
    tip("Deletes the knot; so does the right button on it", {}, false);
    return changed;
}

/// All knots as text, as on the command line.
bool typed_knots(Ui& ui, CurveUse& use, const Parameter& parameter, lutlib::Value& value,
                 const std::string& place) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (!use.is_typing && use.problem.empty()) {
        use.typed = value_text(value);
    }
    const std::string hint =
        "knots as " + name_of_x(parameter) + ":" + name_of_y(parameter) + ", ...";
    ImGui::InputTextWithHint("##knots", hint.c_str(), &use.typed);
    use.is_typing = ImGui::IsItemActive();
    mark(ui, place + ".typed");
    tip("All knots, each as " + name_of_x(parameter) + ":" + name_of_y(parameter) +
            ", between commas; none is the neutral curve",
        usual_text(parameter), false);
    bool changed = false;
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        use.problem.clear();
        try {
            value = use.typed.empty() ? lutlib::Value(Knots{}) : parse_value(parameter, use.typed);
            use.knot.reset();
            changed = true;
        } catch (const lutlib::Error& error) {
            use.problem = error.message();
        }
    }
    if (!use.problem.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text,
                              IM_COL32(warning_color[0], warning_color[1], warning_color[2], 255));
        ImGui::TextWrapped("%s", use.problem.c_str());
        ImGui::PopStyleColor();
    }
    return changed;
}

} // namespace

std::size_t add_knot_on_curve(const Parameter& parameter, Knots& knots, double x) {
    const bool is_neutral_diagonal = knots.empty() && parameter.axis.diagonal;
    const double y = is_neutral_diagonal ? x : curve_of(parameter, knots)(x);
    return add_knot(parameter, knots, rounded(view_of(parameter, knots), {x, y}));
}

bool curve_editor(Ui& ui, std::span<const Parameter> curves, std::span<lutlib::Value> values,
                  const std::string& place,
                  const std::function<void(std::size_t parameter)>& start_picking) {
    CurveUse& use = ui.look.curves[place];
    use.hidden.resize(curves.size());
    use.edited = std::min(use.edited, curves.size() - 1);
    ImGui::PushID(place.c_str());
    if (curves.size() > 1) {
        choose_curve(ui, use, curves, place);
    }
    const Parameter& parameter = curves[use.edited];
    const std::string name = place + "." + std::string(parameter.name);
    bool changed = plot(ui, use, curves, values, place);
    changed |= knot_numbers(ui, use, parameter, std::get<Knots>(values[use.edited]), name);
    ImGui::PushID(static_cast<int>(use.edited));
    changed |= typed_knots(ui, use, parameter, values[use.edited], name);
    ImGui::PopID();
    if (pick_button(ui, "Pick a knot",
                    "Click on the picture: a knot is set where its colour lies on the curve",
                    name + ".pick")) {
        start_picking(use.edited);
    }
    ImGui::PopID();
    return changed;
}

} // namespace preview::panels
