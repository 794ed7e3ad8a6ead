// Files of ASC CDL corrections on the page CDL: open one, choose among several, save.
#include "lutlib/io/correction_files.h"
#include "lutlib/recipe/correction_file.h"
#include "preview/editor/commands.h"
#include "preview/editor/corrections.h"
#include "preview/panels/look_parts.h"
#include "preview/panels/searched_list.h"
#include "preview/panels/tip.h"

#include <algorithm>
#include <filesystem>

namespace preview::panels {

namespace {

/// Of file_kinds(), for the dialog.
std::size_t kind_of_corrections() {
    const auto kinds = file_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(), [](const FileKind& kind) {
        return !kind.extensions.empty() &&
               kind.extensions.front() == lutlib::correction_formats().front().extension;
    });
    return static_cast<std::size_t>(found - kinds.begin());
}

void put(Ui& ui, std::size_t at) {
    CdlUse& use = ui.look.cdl;
    use.chosen = at;
    use.id = use.corrections[at].id;
    use.report = name_of(use.corrections, at) + " of " + use.path + "\n" +
                 put_correction(ui.history.draft(), use.corrections[at]);
    ui.look.chosen = cdl_of(ui.history.draft().recipe);
}

void open(Ui& ui, const std::string& path) {
    attempt(ui, [&] {
        auto corrections = lutlib::io::read_corrections(path);
        ui.look.cdl.path = path;
        ui.look.cdl.corrections = std::move(corrections);
        put(ui, 0);
    });
}

/// Where there are several, by what they are called.
void correction_list(Ui& ui) {
    CdlUse& use = ui.look.cdl;
    if (use.corrections.size() < 2) {
        return;
    }
    const bool is_open = ImGui::BeginCombo(
        "Correction", name_of(use.corrections, use.chosen).c_str(), ImGuiComboFlags_HeightLarge);
    mark(ui, "cdl.corrections");
    tip("Which of the file's corrections the numbers are", {}, false);
    if (!is_open) {
        return;
    }
    if (ImGui::IsWindowAppearing()) {
        ui.search.clear();
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::InputTextWithHint("##search", "search", &ui.search);
    mark(ui, "cdl.corrections.search");
    for (std::size_t i = 0; i < use.corrections.size(); ++i) {
        const std::string name = name_of(use.corrections, i);
        const std::string& words = use.corrections[i].description;
        if (!is_found(name + " " + words, ui.search)) {
            continue;
        }
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Selectable((name + (words.empty() ? "" : ": " + words)).c_str(),
                              i == use.chosen)) {
            put(ui, i);
        }
        mark(ui, "cdl.corrections." + std::to_string(i));
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

} // namespace

void ask_for_correction(Ui& ui) {
    ask_for_file(ui, {.title = "Open an ASC CDL",
                      .button = "Open",
                      .kind = kind_of_corrections(),
                      .chosen = [&ui](const std::string& path) { open(ui, path); }});
}

void ask_to_save_correction(Ui& ui) {
    const State& state = ui.history.draft();
    const std::string& last = ui.look.cdl.path;
    ask_for_file(ui,
                 {.title = "Save the CDL",
                  .button = "Save",
                  .saves = true,
                  .kind = kind_of_corrections(),
                  .chosen =
                      [&ui](const std::string& chosen) {
                          const std::string to = std::filesystem::path(chosen).has_extension()
                                                     ? chosen
                                                     : chosen + ".cc";
                          begin_export(ui, [state = ui.history.draft(), id = ui.look.cdl.id, to] {
                              return prepare_correction(state, id, to);
                          });
                      }},
                 last.empty() ? look_name(state) + ".cc" : last);
}

void cdl_files(Ui& ui) {
    CdlUse& use = ui.look.cdl;
    if (ImGui::Button("Open ...")) {
        ask_for_correction(ui);
    }
    mark(ui, "cdl.open");
    tip("The numbers of a .cc, .ccc or .cdl file", {}, false);
    ImGui::SameLine();
    if (ImGui::Button("Save ...")) {
        ask_to_save_correction(ui);
    }
    mark(ui, "cdl.save");
    tip("A new .cc, or into a .ccc or .cdl, whose other corrections stay", {}, false);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::InputTextWithHint("##id", "id, under which it is saved", &use.id);
    mark(ui, "cdl.id");
    correction_list(ui);
    if (!use.report.empty()) {
        ImGui::TextWrapped("%s", use.report.c_str());
        mark(ui, "cdl.report");
    }
    ImGui::Separator();
}

} // namespace preview::panels
