// What went wrong, the newest first, over a part of the picture and never all of it.
#include "preview/panels/ui.h"

#include <imgui.h>

#include <algorithm>

namespace preview::panels {

namespace {

constexpr float widest_list = 37;                             // heights of the text
constexpr float most_of_width = 0.8F, most_of_height = 0.5F;  // shares of the picture's place
constexpr float least_list_width = 12, least_list_height = 3; // the same in heights of the text

std::string said_by(const Errors::Row& row) {
    return row.count == 1 ? row.text : row.text + " (" + std::to_string(row.count) + " times)";
}

/// How high the rows are, wrapped beside their buttons.
float height_of(const std::vector<Errors::Row>& rows, std::size_t count, float text_width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float height = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string text = said_by(rows[i]);
        const float lines =
            ImGui::CalcTextSize(text.c_str(), nullptr, false, std::max(text_width, 1.0F)).y;
        height += std::max(lines, ImGui::GetFrameHeight()) + style.ItemSpacing.y;
    }
    return height;
}

/// Its button first, so that it is under the mouse for the one that follows.
bool error_row(Ui& ui, std::size_t at) {
    const std::string place = "error." + std::to_string(at);
    ImGui::PushID(place.c_str());
    const bool is_closed = ImGui::Button("x");
    mark(ui, place + ".close");
    ImGui::SameLine();
    ImGui::TextWrapped("%s", said_by(ui.errors.rows()[at]).c_str());
    mark(ui, place);
    ImGui::PopID();
    return is_closed;
}

} // namespace

void error_window(Ui& ui) {
    if (ui.errors.empty()) {
        return;
    }
    const ImGuiStyle& style = ImGui::GetStyle();
    const Rect& over = ui.picture_place;
    const float width =
        std::clamp(over.width * most_of_width, em(least_list_width), em(widest_list));
    const float button = ImGui::CalcTextSize("x").x + 2 * style.FramePadding.x;
    const std::size_t count = std::min(ui.errors.rows().size(), Errors::most_shown);
    const std::string more = ui.errors.more();
    const float text_width =
        width - 2 * style.WindowPadding.x - button - style.ItemSpacing.x - style.ScrollbarSize;
    const float rest = 2 * ImGui::GetFrameHeightWithSpacing() + 2 * style.WindowPadding.y;
    const float most = std::max(over.height * most_of_height - rest, em(least_list_height));
    const float height = std::min(height_of(ui.errors.rows(), count, text_width), most);

    ImGui::SetNextWindowPos({over.x + em(2), over.y + em(2)}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({width, 0});
    const bool open = ImGui::Begin("Error", nullptr,
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    mark_window(ui, "error");
    if (open) {
        std::optional<std::size_t> closed;
        ImGui::BeginChild("errors", {0, height});
        for (std::size_t i = 0; i < count; ++i) {
            closed = error_row(ui, i) ? i : closed;
        }
        ImGui::EndChild();
        if (ImGui::Button(ui.errors.rows().size() == 1 ? "Close" : "Close all")) {
            ui.errors.clear();
        } else if (closed) {
            ui.errors.close(*closed);
        }
        mark(ui, "error.close");
        if (!more.empty()) {
            ImGui::SameLine();
            ImGui::TextDisabled("%s", more.c_str());
            mark(ui, "error.more");
        }
    }
    ImGui::End();
}

} // namespace preview::panels
