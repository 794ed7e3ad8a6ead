#include "preview/panels/scope_region.h"

#include "preview/panels/tip.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace preview::panels {

namespace {

constexpr ImU32 inner = IM_COL32(255, 255, 255, 230), outer = IM_COL32(0, 0, 0, 200);

/// A border that is seen on any picture.
void frame(const ImVec2& low, const ImVec2& high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRect({low.x - 1, low.y - 1}, {high.x + 1, high.y + 1}, outer);
    list.AddRect(low, high, inner);
}

void say_how() {
    constexpr const char* words = "drag over what the scopes shall count (Esc: not)";
    const ImVec2 corner = ImGui::GetItemRectMin(), size = ImGui::CalcTextSize(words);
    const float room = em(0.5F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + size.x + 2 * room, corner.y + size.y + 2 * room},
                       IM_COL32(20, 20, 20, 220));
    list.AddText({corner.x + room, corner.y + room}, IM_COL32(235, 235, 235, 255), words);
}

ScopeRegion between(OutputPoint a, OutputPoint b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

bool any_scope_seen(const ScopeChoice& choice) {
    return std::any_of(choice.seen.begin(), choice.seen.end(), [](bool is) { return is; });
}

} // namespace

bool takes_mouse_for_region(Ui& ui, const Seen& seen) {
    if (!ui.scopes_shown.region_drag) {
        return false;
    }
    RegionDrag& drag = *ui.scopes_shown.region_drag;
    if (ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    }
    say_how();
    if (ImGui::IsItemActivated()) {
        drag.from = share_at_mouse(seen);
    }
    if (!drag.from) {
        return true;
    }
    const ScopeRegion dragged = between(*drag.from, share_at_mouse(seen));
    // A click is no region.
    constexpr float least = 2;
    const bool is_region =
        dragged.width * static_cast<float>(seen.whole.width) * seen.scale >= least &&
        dragged.height * static_cast<float>(seen.whole.height) * seen.scale >= least;
    if (is_region) {
        ui.history.draft().scopes_seen.region = dragged;
    }
    if (!ImGui::IsItemActive()) {
        if (is_region) {
            ui.scopes_shown.region_drag.reset();
        } else {
            drag.from.reset();
        }
    }
    return true;
}

void show_scope_region(const Ui& ui, const Rect& area) {
    const State& state = ui.history.draft();
    const ScopeChoice& choice = state.scopes_seen;
    if (choice.region == ScopeRegion{} || !any_scope_seen(choice)) {
        return;
    }
    const Seen seen = seen_in(ui, area);
    const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
    const ScopeRegion& region = choice.region;
    const int pictures = state.compare == &compare_side ? 2 : 1;
    for (int i = 0; i < pictures; ++i) {
        const float left = static_cast<float>(i) * static_cast<float>(seen.output.width);
        const auto at = [&](float x, float y) {
            return ImVec2(
                area.x +
                    (left + seen.left + seen.scale * x * static_cast<float>(seen.whole.width)) /
                        pixels.x,
                area.y +
                    (seen.top + seen.scale * y * static_cast<float>(seen.whole.height)) / pixels.y);
        };
        ImGui::PushClipRect({area.x + left / pixels.x, area.y},
                            {area.x + (left + static_cast<float>(seen.output.width)) / pixels.x,
                             area.y + area.height},
                            true);
        frame(at(region.x, region.y), at(region.x + region.width, region.y + region.height));
        ImGui::PopClipRect();
    }
}

void scope_region_controls(Ui& ui) {
    ScopeRegion& region = ui.history.draft().scopes_seen.region;
    ImGui::TextUnformatted("Where they measure");
    ImGui::BeginDisabled(ui.scopes_shown.region_drag.has_value());
    if (ImGui::Button("Drag a region")) {
        ui.scopes_shown.region_drag.emplace();
    }
    ImGui::EndDisabled();
    mark(ui, "scope.region.drag");
    tip("then drag over the picture what the scopes shall count", {}, false);
    ImGui::SameLine();
    ImGui::BeginDisabled(region == ScopeRegion{});
    if (ImGui::Button("All of it")) {
        region = {};
    }
    ImGui::EndDisabled();
    mark(ui, "scope.region.clear");
    if (region != ScopeRegion{}) {
        const Size whole = seen_in(ui, ui.picture_place).own;
        const ScopeArea area = texels_of(region, whole);
        ImGui::Text("%ux%u pixels from %u,%u on, of %ux%u", area.width, area.height, area.x, area.y,
                    whole.width, whole.height);
    }
}

} // namespace preview::panels
