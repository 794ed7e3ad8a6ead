#include "preview/panels/ui.h"

#include "lutlib/io/reason.h"
#include "preview/panels/actions.h"
#include "preview/panels/palette.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace preview::panels {

namespace {

struct Panel {
    const char* name;
    void (*draw)(Ui& ui);
};
constexpr Panel panels[] = {
    {"Look", &look_panel},     {"Versions", &versions_panel}, {"View", &view_panel},
    {"Scene", &scene_panel},   {"Files", &file_panel},        {"Passes", &passes_panel},
    {"Scopes", &scopes_panel}, {"Cube", &cube_panel},         {"Colours", &colors_panel},
};

/// What a text field takes for itself.
bool is_for_text(const KeyPress& press) {
    return press.ctrl ? press.key == Key::z || press.key == Key::y : is_printable(press.key);
}

bool is_held(const Ui& ui, Key key) {
    return ui.down[static_cast<std::size_t>(key)];
}

void replace_dialog(Ui& ui) {
    if (!ui.to_replace.empty() && !ImGui::IsPopupOpen("Replace?")) {
        ImGui::OpenPopup("Replace?");
    }
    if (!ImGui::BeginPopupModal("Replace?", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        return;
    }
    ImGui::Text("%s exists already.", ui.to_replace.c_str());
    bool done = ui.to_replace.empty();
    if (ImGui::Button("Replace it")) {
        attempt(ui, ui.replace);
        done = true;
    }
    mark(ui, "replace.yes");
    ImGui::SameLine();
    if (ImGui::Button("Keep it")) {
        done = true;
    }
    mark(ui, "replace.no");
    if (done) {
        ui.to_replace.clear();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

} // namespace

std::vector<std::string> panel_names() {
    std::vector<std::string> out;
    for (const Panel& panel : panels) {
        out.emplace_back(panel.name);
    }
    return out;
}

float em(float heights) {
    return heights * ImGui::GetFontSize();
}

void mark_window(Ui& ui, const std::string& name) {
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    ui.places[name] = {low.x, low.y, size.x, size.y};
}

void mark(Ui& ui, std::string name) {
    std::replace(name.begin(), name.end(), ' ', '-');
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ui.places[name] = {low.x, low.y, high.x - low.x, high.y - low.y};
}

void attempt(Ui& ui, const std::function<void()>& action) {
    const State before = ui.history.draft();
    try {
        action();
    } catch (const std::exception& error) {
        ui.history.draft() = before;
        ui.errors.add(lutlib::io::reason_of(error));
    }
}

void attempt_writing(Ui& ui, const std::string& path, std::function<void()> action) {
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) {
        attempt(ui, action);
        return;
    }
    ui.to_replace = path;
    ui.replace = std::move(action);
}

bool asks_anything(const Ui& ui) {
    return !ui.to_replace.empty() || !ui.file_dialog.title.empty() || ui.exporting.is_busy();
}

void dialogs(Ui& ui) {
    help_window(ui);
    error_window(ui);
    replace_dialog(ui);
    file_dialog(ui);
    export_dialog(ui);
    closing_dialog(ui);
    palette(ui);
}

void handle_shortcuts(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    ui.held = nullptr;
    const std::vector<KeyPress> pressed = std::exchange(ui.pressed, {});
    for (const KeyPress& press : pressed) {
        if (io.WantTextInput && is_for_text(press)) {
            continue;
        }
        for (const Action& action : actions()) {
            if (is_asked_by(action, press)) {
                action.act(ui);
            }
        }
    }
    if (io.WantTextInput) {
        return;
    }
    if (!io.KeyCtrl && is_held(ui, Key::a)) {
        ui.held = &compare_a;
    }
    if (!io.KeyCtrl && is_held(ui, Key::b)) {
        ui.held = &compare_b;
    }
}

/// The panels' tabs, in as many rows as it takes to show each whole.
void tabs(Ui& ui) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < std::size(panels); ++i) {
        const float width = ImGui::CalcTextSize(panels[i].name).x + 2 * style.FramePadding.x +
                            style.ItemSpacing.x / 2;
        if (i > 0 && ImGui::GetItemRectMax().x + width <= right) {
            ImGui::SameLine(0, style.ItemSpacing.x / 2);
        }
        const bool is_open = ui.panel == i;
        ImGui::PushStyleColor(
            ImGuiCol_Button, ImGui::GetStyleColorVec4(is_open ? ImGuiCol_TabActive : ImGuiCol_Tab));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered,
                              ImGui::GetStyleColorVec4(ImGuiCol_TabHovered));
        if (ImGui::Button(panels[i].name)) {
            ui.panel = i;
        }
        ImGui::PopStyleColor(2);
        mark(ui, std::string("tab.") + panels[i].name);
    }
    ImGui::Separator();
}

/// The window of the panels, at the right; its width.
float begin_panels(Ui& ui, ImVec2 window) {
    constexpr float least_width = 24, usual_width = 28.5F; // heights of the text
    const float least = std::min(em(least_width), window.x / 2);
    const float most = std::max(least, window.x * 0.7F);
    const float chosen =
        ui.panels_width > 0 ? em(ui.panels_width) : std::min(em(usual_width), window.x / 2);
    // The picture's columns are pairs, side by side.
    const float left = 2 * std::round((window.x - std::clamp(chosen, least, most)) / 2);
    const float wanted = window.x - left;
    ImGui::SetNextWindowSize({wanted, window.y});
    ImGui::SetNextWindowSizeConstraints({least - 1, window.y}, {most + 1, window.y});
    ImGui::SetNextWindowPos({window.x, 0}, ImGuiCond_Always, {1, 0});
    ImGui::Begin("Panels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings);
    mark_window(ui, "panels");
    const float width = ImGui::GetWindowWidth();
    // A narrow window forgets no width that a person has chosen.
    if (std::abs(width - wanted) > 1) {
        ui.panels_width = width / em(1);
    }
    return width;
}

Rect draw(Ui& ui) {
    ui.places.clear();
    ui.shows_passes = ui.shows_curves = false;
    ui.thumbnails.wanted.clear();
    ui.thumbnails.groups.clear();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    handle_shortcuts(ui);
    const float width = begin_panels(ui, window);
    if (ImGui::Button("Undo")) {
        ui.history.undo();
    }
    mark(ui, "undo");
    ImGui::SameLine();
    if (ImGui::Button("Redo")) {
        ui.history.redo();
    }
    mark(ui, "redo");
    ImGui::SameLine();
    if (ImGui::Button("Help (F1)")) {
        ui.shows_help = true;
    }
    notices(ui);
    tabs(ui);
    ImGui::PushID(panels[ui.panel].name); // each scrolls by itself
    ImGui::BeginChild("panel");
    panels[ui.panel].draw(ui);
    ImGui::EndChild();
    ImGui::PopID();
    ImGui::End();
    const float left = std::max(window.x - width, 1.0F);
    const float status = std::min(ImGui::GetFrameHeight() + em(0.43F), window.y / 2);
    const ScopeChoice& choice = ui.history.draft().scopes_seen;
    const bool any_scope = choice.seen != std::array<bool, scopes.size()>{};
    const float strip = any_scope ? std::floor((window.y - status) * choice.height) : 0;
    const float looks = std::min(look_strip_height(ui), (window.y - status - strip) * 0.6F);
    const float bottom = std::max(window.y - status - strip - looks, 1.0F);
    const Rect area = fitted(ui, {0, 0, left, bottom});
    picture_area(ui, area);
    look_strip(ui, {0, bottom, left, looks});
    scope_strip(ui, {0, bottom + looks, left, strip});
    status_line(ui, {0, window.y - status, left, status});
    dialogs(ui);
    return area;
}

} // namespace preview::panels
