#include "preview/panels/thumbnail.h"

#include "preview/panels/ui.h"

#include <imgui.h>

#include <cmath>
#include <filesystem>
#include <utility>

namespace preview::panels {

namespace {

/// A few lines of text in a box, cut off where it ends.
void write_reason(const std::string& reason, ImVec2 low, ImVec2 high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float inset = em(0.3F);
    list.PushClipRect(low, high, true);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize() * 0.86F, {low.x + inset, low.y + inset},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), reason.c_str(),
                 reason.c_str() + reason.size(), high.x - low.x - 2 * inset);
    list.PopClipRect();
}

std::string name_for_mark(const ThumbnailKey& key) {
    switch (key.kind) {
    case ThumbnailKind::file:
        break;
    case ThumbnailKind::version:
        return "version." + std::to_string(std::stoul(key.name) + 1);
    case ThumbnailKind::scene:
        return "scene." + key.name;
    }
    return std::filesystem::path(key.name).filename().string();
}

/// In the middle of a box, on whole pixels.
PlacedThumbnail in_box(const ThumbnailFact& fact, ImVec2 low, ImVec2 high, float share) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    PlacedThumbnail out;
    out.cell = *fact.cell;
    out.width = static_cast<float>(fact.size.width) * share / scale.x;
    out.height = static_cast<float>(fact.size.height) * share / scale.y;
    out.x = std::floor((low.x + high.x - out.width) / 2);
    out.y = std::floor((low.y + high.y - out.height) / 2);
    const ImVec2 clip_low = ImGui::GetWindowDrawList()->GetClipRectMin();
    const ImVec2 clip_high = ImGui::GetWindowDrawList()->GetClipRectMax();
    out.clip_left = clip_low.x;
    out.clip_top = clip_low.y;
    out.clip_right = clip_high.x;
    out.clip_bottom = clip_high.y;
    return out;
}

} // namespace

void place_thumbnail(Ui& ui, const ThumbnailKey& key, float x, float y, float share) {
    const ImVec2 low{std::floor(x), std::floor(y)};
    const ImVec2 high{low.x + std::floor(em(thumbnail_width) * share),
                      low.y + std::floor(em(thumbnail_height) * share)};
    if (!ImGui::IsRectVisible(low, high)) {
        return;
    }
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg));
    Thumbnails& all = ui.thumbnails;
    all.wanted.push_back(key);
    const auto found = all.facts.find(key);
    if (found == all.facts.end()) {
        return;
    }
    const std::string name = name_for_mark(key);
    if (found->second.cell) {
        const PlacedThumbnail placed = in_box(found->second, low, high, share);
        all.placed.push_back(placed);
        ui.places["picture-of." + name] = {placed.x, placed.y, placed.width, placed.height};
    } else if (!found->second.reason.empty()) {
        write_reason(found->second.reason, low, high);
        ui.places["reason-of." + name] = {low.x, low.y, high.x - low.x, high.y - low.y};
    }
}

void show_thumbnails(Ui& ui) {
    Thumbnails& all = ui.thumbnails;
    if (!all.placed.empty() && all.draw != nullptr) {
        all.groups.push_back(std::exchange(all.placed, {}));
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddCallback(all.draw, &all.groups.back());
        list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
    }
    all.placed.clear();
}

} // namespace preview::panels
