// Drawing curves: the plot's part of the window, what lies behind the curves, curves and knots.
#pragma once

#include "preview/editor/knots.h"
#include "preview/panels/ui.h"

#include <imgui.h>

#include <optional>
#include <string>

namespace preview::panels {

inline constexpr float knot_radius = 0.36F; ///< in heights of the text

/// Maps between the view and the window's pixels.
struct Canvas {
    CurveView view;
    ImVec2 origin, size;

    ImVec2 at(lutlib::Knot knot) const;
    lutlib::Knot knot(ImVec2 place) const;
};

/// What is behind the curves: the colours of a hue axis, a grid, how often the picture has the
/// values of the parameter's axis, and the neutral curve.
void draw_backdrop(const Ui& ui, const Canvas& canvas, const lutlib::Parameter& parameter);
/// The curve's own colour, of 0 to 255 parts opacity.
ImU32 curve_color(const lutlib::Parameter& parameter, int opacity);
/// In the curve's own colour; faint where another curve is edited.
void draw_curve(const Canvas& canvas, const lutlib::Parameter& parameter,
                const lutlib::Knots& knots, bool is_edited);
void draw_knots(const Canvas& canvas, const lutlib::Knots& knots, std::optional<std::size_t> lit);

/// What the axes are called, in words: "hue", "saturation gain"; of tone curves "input", "output".
std::string name_of_x(const lutlib::Parameter& parameter);
std::string name_of_y(const lutlib::Parameter& parameter);

/// Names and ends of the axes, in the plot's corners and below it.
void draw_axis_names(const Canvas& canvas, const lutlib::Parameter& parameter);

} // namespace preview::panels
