#include "preview/panels/ui.h"

#include "lutlib/io/reason.h"
#include "preview/editor/commands.h"
#include "preview/editor/reload.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/trigonometric.hpp>
#include <utility>

namespace preview::panels {

namespace {

struct Panel {
    const char* name;
    void (*draw)(Ui& ui);
};
constexpr Panel panels[] = {
    {"Look", &look_panel},  {"View", &view_panel},     {"Scene", &scene_panel},
    {"Files", &file_panel}, {"Passes", &passes_panel}, {"Scopes", &scopes_panel},
    {"Cube", &cube_panel},
};

struct Shortcut {
    const char* keys;
    const char* help;
    Key key;
    bool ctrl, shift;
    void (*action)(Ui& ui);
};

void compare_by(Ui& ui, const Compare& row) {
    ui.history.draft().compare = &row;
}

constexpr Shortcut shortcuts[] = {
    {"F1", "this list", Key::f1, false, false, [](Ui& ui) { ui.shows_help = !ui.shows_help; }},
    {"Esc", "close it, errors, questions and what was exported", Key::escape, false, false,
     [](Ui& ui) {
         ui.shows_help = false;
         ui.errors.clear();
         ui.exported.clear();
         ui.to_replace.clear();
     }},
    {"Ctrl+Z", "undo", Key::z, true, false, [](Ui& ui) { ui.history.undo(); }},
    {"Ctrl+Shift+Z", "redo", Key::z, true, true, [](Ui& ui) { ui.history.redo(); }},
    {"Ctrl+Y", "redo", Key::y, true, false, [](Ui& ui) { ui.history.redo(); }},
    {"Ctrl+S", "save the recipe to its file", Key::s, true, false,
     [](Ui& ui) {
         const std::string path = ui.history.draft().recipe_path;
         const auto save = [&ui, path] { save_recipe(ui.history, path); };
         if (path.empty()) {
             ui.errors.emplace_back("the recipe has no file yet: save it under Files");
         } else if (ui.offered || !is_file_as_saved(ui.history.draft())) {
             attempt_writing(ui, path, save);
         } else {
             attempt(ui, save);
         }
     }},
    {"Ctrl+E", "export the strip into the engine's folder (--watch-engine-folder)", Key::e, true,
     false, &export_to_engine},
    {"Ctrl+Shift+R", "make everything on the GPU anew", Key::r, true, true,
     [](Ui& ui) { ui.wants_new_screen = true; }},
    {"Ctrl+Q", "quit", Key::q, true, false, [](Ui& ui) { ui.quits = true; }},
    {"1", "side A alone", Key::digit_1, false, false, [](Ui& ui) { compare_by(ui, compare_a); }},
    {"2", "side B alone", Key::digit_2, false, false, [](Ui& ui) { compare_by(ui, compare_b); }},
    {"3", "split by a line", Key::digit_3, false, false,
     [](Ui& ui) { compare_by(ui, compare_split); }},
    {"4", "side by side", Key::digit_4, false, false, [](Ui& ui) { compare_by(ui, compare_side); }},
    {"5", "difference", Key::digit_5, false, false,
     [](Ui& ui) { compare_by(ui, compare_difference); }},
};

/// What a text field takes for itself.
bool is_for_text(const KeyPress& press) {
    return press.ctrl ? press.key == Key::z || press.key == Key::y : is_printable(press.key);
}

bool is_held(const Ui& ui, Key key) {
    return ui.down[static_cast<std::size_t>(key)];
}

constexpr const char* mouse_help[][2] = {
    {"hold A, hold B", "that side alone, while held"},
    {"drag the line", "move the split"},
    {"drag the picture", "turn the camera about what it looks at"},
    {"with Shift, or the middle button", "carry both to the side"},
    {"with the right button", "turn the camera where it stands"},
    {"wheel", "zoom"},
    {"point at the picture", "its colour before and after the looks, in the line below"},
    {"drag the cube", "turn it"},
};

void mark_window(Ui& ui, const std::string& name) {
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    ui.places[name] = {low.x, low.y, size.x, size.y};
}

void help_window(Ui& ui) {
    if (!ui.shows_help) {
        return;
    }
    ImGui::SetNextWindowPos({30, 30}, ImGuiCond_Appearing);
    const bool open = ImGui::Begin("Help", &ui.shows_help, ImGuiWindowFlags_AlwaysAutoResize);
    mark_window(ui, "help");
    if (open && ImGui::BeginTable("keys", 2)) {
        const auto row = [](const char* keys, const char* help) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(keys);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(help);
        };
        for (const Shortcut& shortcut : shortcuts) {
            row(shortcut.keys, shortcut.help);
        }
        for (const auto& line : mouse_help) {
            row(line[0], line[1]);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

void error_window(Ui& ui) {
    if (ui.errors.empty()) {
        return;
    }
    ImGui::SetNextWindowPos({30, 60}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({520, 0});
    const bool open = ImGui::Begin("Error", nullptr, ImGuiWindowFlags_NoCollapse);
    mark_window(ui, "error");
    if (open) {
        for (const std::string& error : ui.errors) {
            ImGui::TextWrapped("%s", error.c_str());
        }
        if (ImGui::Button("Close")) {
            ui.errors.clear();
        }
        mark(ui, "error.close");
    }
    ImGui::End();
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
        ui.errors.emplace_back(lutlib::io::reason_of(error));
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

void dialogs(Ui& ui) {
    help_window(ui);
    error_window(ui);
    replace_dialog(ui);
}

void handle_shortcuts(Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    ui.held = nullptr;
    const std::vector<KeyPress> pressed = std::exchange(ui.pressed, {});
    for (const KeyPress& press : pressed) {
        if (io.WantTextInput && is_for_text(press)) {
            continue;
        }
        for (const Shortcut& shortcut : shortcuts) {
            if (press.key == shortcut.key && press.ctrl == shortcut.ctrl &&
                press.shift == shortcut.shift) {
                shortcut.action(ui);
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

void picture_area(Ui& ui, const Rect& area) {
    constexpr float line_reach = 8; // pixels
    constexpr float zoom_per_notch = 0.9F;
    static bool moves_line = false; // one mouse, one drag
    State& state = ui.history.draft();
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
    ui.pointer.reset();
    if (ImGui::IsItemHovered()) {
        ui.pointer = {static_cast<int>((io.MousePos.x - area.x) * io.DisplayFramebufferScale.x),
                      static_cast<int>((io.MousePos.y - area.y) * io.DisplayFramebufferScale.y)};
    }
    const float line = area.x + state.split * area.width;
    const bool near_line =
        state.compare == &compare_split && std::abs(io.MousePos.x - line) < line_reach;
    if (ImGui::IsItemActivated()) {
        moves_line = near_line;
    }
    if (ImGui::IsItemActive() && moves_line) {
        state.split = std::clamp((io.MousePos.x - area.x) / area.width, 0.0F, 1.0F);
    } else if (ImGui::IsItemActive() && ui.facts.is_scene) {
        drag_camera(state.orbit, area);
    }
    if (ImGui::IsItemHovered() && near_line) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    if (ImGui::IsItemHovered() && ui.facts.is_scene && io.MouseWheel != 0) {
        state.orbit.distance *= std::pow(zoom_per_notch, io.MouseWheel);
    }
    ImGui::End();
}

/// The largest part of `area`, in its middle, that shows the picture as it is.
Rect fitted(const Ui& ui, const Rect& area) {
    if (ui.facts.aspect <= 0) {
        return area;
    }
    const Compare* compare = ui.held != nullptr ? ui.held : ui.history.draft().compare;
    const float aspect = ui.facts.aspect * (compare == &compare_side ? 2.0F : 1.0F);
    const float width = std::max(std::floor(std::min(area.width, area.height * aspect)), 1.0F);
    const float height = std::max(std::floor(std::min(area.height, area.width / aspect)), 1.0F);
    return {area.x + std::floor((area.width - width) / 2),
            area.y + std::floor((area.height - height) / 2), width, height};
}

Rect draw(Ui& ui) {
    constexpr float least_width = 340;
    ui.places.clear();
    ui.shows_passes = ui.shows_curves = false;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    handle_shortcuts(ui);
    ImGui::SetNextWindowSize({std::min(440.0F, window.x / 2), window.y}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({std::min(least_width, window.x / 2), window.y},
                                        {std::max(least_width, window.x * 0.7F), window.y});
    ImGui::SetNextWindowPos({window.x, 0}, ImGuiCond_Always, {1, 0});
    ImGui::Begin("Panels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    mark_window(ui, "panels");
    const float width = ImGui::GetWindowWidth();
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
    if (ImGui::BeginTabBar("panels")) {
        for (const Panel& panel : panels) {
            const bool open = ImGui::BeginTabItem(panel.name);
            mark(ui, std::string("tab.") + panel.name);
            if (!open) {
                continue;
            }
            ImGui::BeginChild("panel");
            panel.draw(ui);
            ImGui::EndChild();
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
    const float left = std::max(window.x - width, 1.0F);
    const float status = std::min(ImGui::GetFrameHeight() + 6, window.y / 2);
    const ScopeChoice& choice = ui.history.draft().scopes_seen;
    const bool any_scope = choice.seen != std::array<bool, scopes.size()>{};
    const float strip = any_scope ? std::floor((window.y - status) * choice.height) : 0;
    const float bottom = std::max(window.y - status - strip, 1.0F);
    const Rect area = fitted(ui, {0, 0, left, bottom});
    picture_area(ui, area);
    scope_strip(ui, {0, bottom, left, strip});
    status_line(ui, {0, window.y - status, left, status});
    dialogs(ui);
    return area;
}

} // namespace preview::panels
