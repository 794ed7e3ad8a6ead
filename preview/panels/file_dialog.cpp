#include "preview/panels/file_dialog.h"

#include "preview/editor/commands.h"
#include "preview/editor/search.h"
#include "preview/panels/ui.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace preview::panels {

namespace fs = std::filesystem;

namespace {

constexpr const char* popup = "###file";

void go_to(FileDialog& dialog, const std::string& folder) {
    dialog.folder = folder;
    dialog.typed.clear();
    dialog.at = 0;
    dialog.wants_focus = true;
}

/// What the list shows of the folder: a name that is typed to save narrows nothing.
std::vector<const FolderEntry*> rows_of(FileDialog& dialog) {
    const std::string wanted = std::to_string(dialog.kind) + ' ' + dialog.folder;
    if (dialog.listed != wanted) {
        dialog.list = list_folder(dialog.folder, file_kinds()[dialog.kind]);
        dialog.listed = wanted;
    }
    std::vector<const FolderEntry*> out;
    for (const FolderEntry& entry : dialog.list.entries) {
        if (dialog.saves || is_found(entry.name, dialog.typed)) {
            out.push_back(&entry);
        }
    }
    return out;
}

/// Goes into a folder, or takes a file and closes.
void take(Ui& ui, const std::string& path) {
    FileDialog& dialog = ui.file_dialog;
    std::error_code unknown;
    if (fs::is_directory(path, unknown)) {
        go_to(dialog, path);
        return;
    }
    const auto chosen = dialog.chosen;
    const bool picks_folder = dialog.picks_folder;
    ui.last_folder = fs::path(path).parent_path().string();
    dialog = {};
    chosen(picks_folder ? ui.last_folder : path);
}

void take_folder(Ui& ui) {
    const auto chosen = ui.file_dialog.chosen;
    ui.last_folder = ui.file_dialog.folder;
    ui.file_dialog = {};
    chosen(ui.last_folder);
}

/// What Enter and the button take: a path that is there or that is saved to, else the row chosen.
void take_typed(Ui& ui, const std::vector<const FolderEntry*>& rows) {
    FileDialog& dialog = ui.file_dialog;
    const std::string typed = path_in(dialog.folder, dialog.typed);
    std::error_code unknown;
    if (!dialog.typed.empty() && (dialog.saves || fs::exists(typed, unknown))) {
        take(ui, typed);
    } else if (!dialog.saves && dialog.at < rows.size()) {
        take(ui, path_in(dialog.folder, rows[dialog.at]->name));
    }
}

void places_line(Ui& ui) {
    FileDialog& dialog = ui.file_dialog;
    if (ImGui::Button("Up")) {
        go_to(dialog, path_in(dialog.folder, ".."));
    }
    mark(ui, "file.up");
    ImGui::SameLine();
    if (ImGui::Button("Home")) {
        go_to(dialog, path_in(dialog.folder, "~"));
    }
    mark(ui, "file.home");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(em(14));
    if (ImGui::BeginCombo("##kind", file_kinds()[dialog.kind].label.data())) {
        for (std::size_t i = 0; i < file_kinds().size(); ++i) {
            if (ImGui::Selectable(file_kinds()[i].label.data(), i == dialog.kind)) {
                dialog.kind = i;
            }
        }
        ImGui::EndCombo();
    }
    mark(ui, "file.kind");
    ImGui::TextWrapped("%s", dialog.folder.c_str());
}

void recent_list(Ui& ui, float width, float height) {
    ImGui::BeginChild("recent", {width, height}, true);
    ImGui::TextDisabled("Opened or saved last");
    const std::vector<std::string> recent = ui.recent; // taking one changes them
    for (std::size_t i = 0; i < recent.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const fs::path path(recent[i]);
        if (ImGui::Selectable(path.filename().c_str())) {
            if (ui.file_dialog.saves) {
                go_to(ui.file_dialog, path.parent_path().string());
            } else {
                take(ui, recent[i]);
            }
        }
        mark(ui, "file.recent." + std::to_string(i));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", recent[i].c_str());
        }
        ImGui::PopID();
    }
    ImGui::EndChild();
}

void entry_list(Ui& ui, const std::vector<const FolderEntry*>& rows, float height) {
    FileDialog& dialog = ui.file_dialog;
    ImGui::BeginChild("entries", {0, height}, true);
    if (!dialog.list.reason.empty()) {
        ImGui::TextWrapped("%s", dialog.list.reason.c_str());
        mark(ui, "file.reason");
    } else if (rows.empty()) {
        ImGui::TextDisabled("nothing of this kind, or of what is typed, is here");
    }
    std::string taken;
    ImGuiListClipper clipper; // a folder may have very many
    clipper.Begin(static_cast<int>(rows.size()));
    while (clipper.Step()) {
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
            const FolderEntry& entry = *rows[static_cast<std::size_t>(row)];
            ImGui::PushID(row);
            const bool is_at = !dialog.saves && static_cast<std::size_t>(row) == dialog.at;
            if (ImGui::Selectable((entry.name + (entry.is_folder ? "/" : "")).c_str(), is_at,
                                  ImGuiSelectableFlags_AllowDoubleClick |
                                      ImGuiSelectableFlags_DontClosePopups)) {
                dialog.at = static_cast<std::size_t>(row);
                if (entry.is_folder || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
                    taken = path_in(dialog.folder, entry.name);
                } else if (dialog.saves) {
                    dialog.typed = entry.name;
                }
            }
            mark(ui, "file." + std::to_string(row));
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
    if (!taken.empty()) {
        take(ui, taken);
    }
}

void move_row(FileDialog& dialog, std::size_t count) {
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    dialog.at = count == 0 ? 0 : std::min(dialog.at, count - 1);
    if (count > 0 && pressed(ImGuiKey_DownArrow)) {
        dialog.at = (dialog.at + 1) % count;
    } else if (count > 0 && pressed(ImGuiKey_UpArrow)) {
        dialog.at = (dialog.at + count - 1) % count;
    }
}

} // namespace

void ask_for_file(Ui& ui, FileDialog dialog, const std::string& name) {
    std::error_code unknown;
    const fs::path path(name);
    const std::string current = fs::current_path(unknown).string();
    dialog.folder = path.has_parent_path()   ? path_in(current, path.parent_path().string())
                    : ui.last_folder.empty() ? current
                                             : ui.last_folder;
    dialog.typed = path.filename().string();
    ui.file_dialog = std::move(dialog);
}

void ask_to_open(Ui& ui) {
    ask_for_file(ui, {.title = "Open", .button = "Open", .chosen = [&ui](const std::string& path) {
                          ui.to_open.push_back(path);
                      }});
}

void ask_to_save(Ui& ui) {
    const State& state = ui.history.draft();
    const std::string& path = state.recipe_path;
    ask_for_file(ui,
                 {.title = "Save the recipe",
                  .button = "Save",
                  .saves = true,
                  .chosen =
                      [&ui](const std::string& chosen) {
                          const std::string to =
                              fs::path(chosen).has_extension() ? chosen : chosen + ".json";
                          attempt_writing(ui, to, [&ui, to] {
                              save_recipe(ui.history, to);
                              remember_file(ui.recent, to);
                              ui.report = "saved " + to + "\n";
                          });
                      }},
                 path.empty() ? look_name(state) + ".json" : path);
}

void file_dialog(Ui& ui) {
    FileDialog& dialog = ui.file_dialog;
    if (!dialog.title.empty() && !ImGui::IsPopupOpen(popup)) {
        ImGui::OpenPopup(popup);
    }
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize({std::min(em(52), room.x - em(1)), std::min(em(32), room.y - em(1))});
    ImGui::SetNextWindowPos({room.x / 2, room.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal((dialog.title + popup).c_str(), nullptr,
                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings)) {
        return;
    }
    places_line(ui);
    const float below = 2 * ImGui::GetFrameHeightWithSpacing();
    const float height = std::max(ImGui::GetContentRegionAvail().y - below, em(3));
    const std::string folder = dialog.folder;
    recent_list(ui, ImGui::GetContentRegionAvail().x * 0.3F, height);
    ImGui::SameLine();
    const std::vector<const FolderEntry*> rows =
        dialog.title.empty() ? std::vector<const FolderEntry*>() : rows_of(dialog);
    move_row(dialog, rows.size());
    entry_list(ui, rows, height);
    // The rows are of this list no more once another folder is chosen.
    const bool is_here = !dialog.title.empty() && dialog.folder == folder;
    if (ImGui::IsWindowAppearing() || std::exchange(dialog.wants_focus, false)) {
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    const std::string before = dialog.typed;
    const bool entered = ImGui::InputTextWithHint(
        "##name", dialog.saves ? "the file's name" : "type to find, or a path", &dialog.typed,
        ImGuiInputTextFlags_EnterReturnsTrue);
    mark(ui, "file.name");
    dialog.at = dialog.typed == before ? dialog.at : 0;
    const bool pressed = ImGui::Button(dialog.button.empty() ? "##gone" : dialog.button.c_str());
    mark(ui, "file.choose");
    ImGui::SameLine();
    const bool cancelled = ImGui::Button("Cancel");
    mark(ui, "file.cancel");
    if (is_here && pressed && dialog.picks_folder) {
        take_folder(ui);
    } else if (is_here && (entered || pressed)) {
        take_typed(ui, rows);
        dialog.wants_focus = entered;
    }
    if (cancelled) {
        dialog = {};
    }
    if (dialog.title.empty()) {
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

} // namespace preview::panels
