// The mouse on the picture: the line of a comparison, the camera, which part of it is seen, and the
// colour under it.
#include "preview/panels/eyedropper.h"
#include "preview/panels/scope_region.h"
#include "preview/panels/seen.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace preview::panels {

namespace {

/// Which part of a comparison's border the mouse takes.
struct Grip {
    bool is_line = false;
    bool left = false, right = false, upper = false, lower = false; ///< sides of the box
    bool is_new_box = false;                                        ///< drawn from `from` on
    OutputPoint from{};                                             ///< in shares of the picture
    bool any() const { return is_line || left || right || upper || lower || is_new_box; }
};

Grip grip_at(const State& state, const Seen& seen, float reach) {
    Grip out;
    if (!state.compare->shows_one) {
        return out;
    }
    const WipeShape shape = placed(wipe_shape(state, *state.compare, seen.whole), *state.compare,
                                   seen.left, seen.top, seen.scale);
    const OutputPoint at = seen.mouse;
    if (state.compare != &compare_box) {
        out.is_line = std::abs(at.x * shape[0] + at.y * shape[1] - shape[2]) < reach;
        return out;
    }
    const bool is_across = at.x > shape[0] - reach && at.x < shape[2] + reach;
    const bool is_down = at.y > shape[1] - reach && at.y < shape[3] + reach;
    out.left = is_down && std::abs(at.x - shape[0]) < reach;
    out.right = is_down && !out.left && std::abs(at.x - shape[2]) < reach;
    out.upper = is_across && std::abs(at.y - shape[1]) < reach;
    out.lower = is_across && !out.upper && std::abs(at.y - shape[3]) < reach;
    return out;
}

/// Moves a box's side that begins at `begin` and is `length` long.
void move_sides(bool first, bool last, float to, float& begin, float& length) {
    constexpr float least = 0.01F;
    const float end = begin + length;
    if (first) {
        begin = std::min(to, end - least);
        length = end - begin;
    } else if (last) {
        length = std::max(to - begin, least);
    }
}

void drag_border(State& state, const Grip& grip, const Seen& seen) {
    if (grip.is_line) {
        state.split = split_at(state.split_angle, (seen.mouse.x - seen.left) / seen.scale,
                               (seen.mouse.y - seen.top) / seen.scale, seen.whole);
        return;
    }
    const OutputPoint to = share_at_mouse(seen);
    if (grip.is_new_box) {
        state.box_x = std::min(grip.from.x, to.x);
        state.box_y = std::min(grip.from.y, to.y);
        state.box_width = std::abs(grip.from.x - to.x);
        state.box_height = std::abs(grip.from.y - to.y);
        return;
    }
    move_sides(grip.left, grip.right, to.x, state.box_x, state.box_width);
    move_sides(grip.upper, grip.lower, to.y, state.box_y, state.box_height);
}

ImGuiMouseCursor cursor_of(const Grip& grip, const State& state) {
    const bool is_level = grip.is_line && std::abs(std::remainder(state.split_angle, 180.0F)) > 45;
    const bool across = grip.left || grip.right, down = grip.upper || grip.lower;
    return across && down     ? ImGuiMouseCursor_ResizeAll
           : down || is_level ? ImGuiMouseCursor_ResizeNS
                              : ImGuiMouseCursor_ResizeEW;
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
    static Grip taken; // one mouse, one drag
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
    show_scope_region(ui, area);
    if (takes_mouse_for_pick(ui) || takes_mouse_for_region(ui, seen)) {
        ImGui::End();
        return;
    }
    const Grip grip = grip_at(state, seen, line_reach * io.DisplayFramebufferScale.x);
    if (ImGui::IsItemActivated()) {
        taken = grip;
        if (state.compare == &compare_box && ImGui::IsMouseDown(ImGuiMouseButton_Right)) {
            taken = {.is_new_box = true, .from = share_at_mouse(seen)};
        }
    }
    if (ImGui::IsItemActive() && taken.any()) {
        drag_border(state, taken, seen);
    } else if (ImGui::IsItemActive()) {
        drag_picture(ui, seen, area);
    }
    if (ImGui::IsItemHovered() && grip.any()) {
        ImGui::SetMouseCursor(cursor_of(grip, state));
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
