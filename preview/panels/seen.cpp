#include "preview/panels/seen.h"

#include <imgui.h>

#include <algorithm>

namespace preview::panels {

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
    out.whole = out.output;
    if (out.zoom.scale > 0) {
        const ZoomPlace place = zoom_place(out.zoom, out.own, out.own, out.output);
        out.left = static_cast<float>(place.left);
        out.top = static_cast<float>(place.top);
        out.scale = place.scale;
        out.whole = out.own;
    }
    return out;
}

OutputPoint share_at_mouse(const Seen& seen) {
    const auto share = [&](float at, float begin, std::uint32_t length) {
        return std::clamp((at - begin) / seen.scale / static_cast<float>(length), 0.0F, 1.0F);
    };
    return {share(seen.mouse.x, seen.left, seen.whole.width),
            share(seen.mouse.y, seen.top, seen.whole.height)};
}

} // namespace preview::panels
