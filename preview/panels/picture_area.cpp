// The mouse on the picture: the line of a comparison, the camera, which part of it is seen, and the
// colour under it.
#include "preview/panels/eyedropper.h"
#include "preview/panels/ui.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace preview::panels {

namespace {

/// The picture's part of the window, in its pixels, and what of the picture is seen there.
struct Seen {
    Size own, output; ///< the picture's, and that of one side's part of the window
    Zoom zoom;        ///< as the frame takes it
    OutputPoint mouse;
    float line = 0; ///< where that of a comparison stands, across
};

Seen seen_in(const Ui& ui, const Rect& area) {
    const State& state = ui.history.draft();
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 pixels = io.DisplayFramebufferScale;
    const auto length = [](float pixels_long) {
        return std::max(static_cast<std::uint32_t>(pixels_long), 1U);
    };
    Seen out;
    out.output = picture_size({length(area.width * pixels.x), length(area.height * pixels.y)},
                              *state.compare);
    out.own = ui.facts.is_scene ? out.output : ui.facts.picture_size;
    out.zoom = state.zoom;
    if (ui.facts.is_scene && out.zoom.scale > 0) {
        out.zoom.scale = std::max(out.zoom.scale, 1.0F);
    }
    out.mouse = {(io.MousePos.x - area.x) * pixels.x, (io.MousePos.y - area.y) * pixels.y};
    const auto half = static_cast<float>(out.output.width);
    if (state.compare == &compare_side && out.mouse.x >= half) {
        out.mouse.x -= half;
    }
    out.line = state.split * half;
    if (out.zoom.scale > 0) {
        const ZoomPlace place = zoom_place(out.zoom, out.own, out.own, out.output);
        out.line = static_cast<float>(place.left) +
                   state.split * place.scale * static_cast<float>(out.own.width);
    }
    return out;
}

/// The share of the picture's width that is under the mouse.
float split_at_mouse(const Seen& seen) {
    float left = 0, width = static_cast<float>(seen.output.width);
    if (seen.zoom.scale > 0) {
        const ZoomPlace place = zoom_place(seen.zoom, seen.own, seen.own, seen.output);
        left = static_cast<float>(place.left);
        width = place.scale * static_cast<float>(seen.own.width);
    }
    return std::clamp((seen.mouse.x - left) / width, 0.0F, 1.0F);
}

/// The left button turns the camera about its target, the middle one or Shift carries both along,
/// the right one turns the camera where it stands.
void drag_camera(Orbit& orbit, const Rect& area) {
    constexpr float degrees_per_pixel = 0.3F;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 by = io.MouseDelta;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || io.KeyShift) {
        // What lies at the target's distance stays under the mouse.
        const float metres_per_pixel =
            2 * orbit.distance * std::tan(glm::radians(orbit.field_of_view) / 2) / area.height;
        orbit.pan += metres_per_pixel * glm::vec2(-by.x, by.y);
    } else if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
        orbit = turned_on_the_spot(orbit, degrees_per_pixel * by.x, -degrees_per_pixel * by.y);
    } else {
        orbit.azimuth = std::remainder(orbit.azimuth - degrees_per_pixel * by.x, 360.0F);
        orbit.elevation = std::clamp(orbit.elevation + degrees_per_pixel * by.y, -89.0F, 89.0F);
    }
}

/// A picture has no camera: without Ctrl the mouse moves what is seen of it.
bool moves_pixels(const Ui& ui) {
    return !ui.facts.is_scene || ImGui::GetIO().KeyCtrl;
}

void drag_picture(Ui& ui, const Seen& seen, const Rect& area) {
    State& state = ui.history.draft();
    const ImGuiIO& io = ImGui::GetIO();
    if (!moves_pixels(ui)) {
        drag_camera(state.orbit, area);
    } else if (seen.zoom.scale > 0 && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
        state.zoom = panned_by(seen.zoom,
                               {io.MouseDelta.x * io.DisplayFramebufferScale.x,
                                io.MouseDelta.y * io.DisplayFramebufferScale.y},
                               seen.own, seen.output);
    }
}

void turn_wheel(Ui& ui, const Seen& seen, float notches) {
    constexpr float distance_per_notch = 0.9F, scale_per_notch = 1.25F;
    State& state = ui.history.draft();
    if (moves_pixels(ui)) {
        state.zoom = zoomed_by(seen.zoom, std::pow(scale_per_notch, notches), seen.mouse, seen.own,
                               seen.output);
    } else {
        state.orbit.distance *= std::pow(distance_per_notch, notches);
    }
}

} // namespace

void zoom_to(Ui& ui, float scale) {
    const Seen seen = seen_in(ui, ui.picture_place);
    Zoom& zoom = ui.history.draft().zoom;
    const float from = seen.zoom.scale > 0 ? seen.zoom.scale : fitting_scale(seen.own, seen.output);
    const OutputPoint middle{static_cast<float>(seen.output.width) / 2,
                             static_cast<float>(seen.output.height) / 2};
    zoom = scale > 0 ? zoomed_by(seen.zoom, scale / from, ui.pointer ? seen.mouse : middle,
                                 seen.own, seen.output)
                     : Zoom{.magnifier = zoom.magnifier};
    zoom.scale = scale;
}

void picture_area(Ui& ui, const Rect& area) {
    const float line_reach = em(0.6F);
    static bool moves_line = false; // one mouse, one drag
    State& state = ui.history.draft();
    ui.picture_place = area;
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("Picture", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    ImGui::InvisibleButton("picture", {area.width, area.height},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    mark(ui, "picture");
    const ImGuiIO& io = ImGui::GetIO();
    const Seen seen = seen_in(ui, area);
    ui.pointer.reset();
    if (ImGui::IsItemHovered()) {
        ui.pointer = {static_cast<int>((io.MousePos.x - area.x) * io.DisplayFramebufferScale.x),
                      static_cast<int>((io.MousePos.y - area.y) * io.DisplayFramebufferScale.y)};
    }
    if (takes_mouse_for_pick(ui)) {
        ImGui::End();
        return;
    }
    const bool near_line =
        state.compare == &compare_split &&
        std::abs(seen.mouse.x - seen.line) < line_reach * io.DisplayFramebufferScale.x;
    if (ImGui::IsItemActivated()) {
        moves_line = near_line;
    }
    if (ImGui::IsItemActive() && moves_line) {
        state.split = split_at_mouse(seen);
    } else if (ImGui::IsItemActive()) {
        drag_picture(ui, seen, area);
    }
    if (ImGui::IsItemHovered() && near_line) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
        turn_wheel(ui, seen, io.MouseWheel);
    }
    ImGui::End();
}

Size Ui::picture_size() const {
    const bool is_pair = history.draft().compare == &compare_side;
    Size own = facts.picture_size;
    if (facts.is_scene) {
        own = {std::max(static_cast<std::uint32_t>(picture_place.width), 2U) & ~1U,
               std::max(static_cast<std::uint32_t>(picture_place.height), 1U)};
    } else if (is_pair) {
        own.width *= 2;
    }
    if (picture_width == 0) {
        return own;
    }
    const auto width = static_cast<std::uint32_t>(picture_width);
    const double height = static_cast<double>(width) * own.height / own.width;
    return {width, std::max(static_cast<std::uint32_t>(std::lround(height)), 1U)};
}

Rect fitted(const Ui& ui, const Rect& area) {
    const State& state = ui.history.draft();
    if (ui.facts.is_scene || state.zoom.scale > 0) {
        return area;
    }
    const Compare* compare = ui.held != nullptr ? ui.held : state.compare;
    const float aspect = static_cast<float>(ui.facts.picture_size.width) /
                         static_cast<float>(ui.facts.picture_size.height) *
                         (compare == &compare_side ? 2.0F : 1.0F);
    const float width = std::max(std::floor(std::min(area.width, area.height * aspect)), 1.0F);
    const float height = std::max(std::floor(std::min(area.height, area.width / aspect)), 1.0F);
    return {area.x + std::floor((area.width - width) / 2),
            area.y + std::floor((area.height - height) / 2), width, height};
}

} // namespace preview::panels
