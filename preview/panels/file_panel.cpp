// Files in and out: look, recipe, strip; what an export lost.
#include "preview/editor/commands.h"
#include "preview/panels/file_actions.h"
#include "preview/panels/ui.h"

#include <imgui.h>
#include <imgui_stdlib.h>

namespace preview::panels {

namespace {

/// A line to type a path in, which shows `usual` while nothing was typed, and a button.
bool path_line(Ui& ui, const char* button, std::string& typed, const std::string& usual,
               const std::string& place) {
    ImGui::PushID(place.c_str());
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.62F);
    const bool entered = ImGui::InputTextWithHint("##path", usual.c_str(), &typed,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    mark(ui, place + ".path");
    ImGui::SameLine();
    const bool pressed = ImGui::Button(button);
    mark(ui, place);
    ImGui::PopID();
    return entered || pressed;
}

std::string path_or(const std::string& typed, const std::string& usual) {
    return typed.empty() ? usual : typed;
}

} // namespace

void file_panel(Ui& ui) {
    State& state = ui.history.draft();
    ImGui::TextWrapped("Open a recipe, LUT, picture or glTF model, or drop it on the window.");
    if (ImGui::Button("Choose a file ... (Ctrl+O)")) {
        ask_to_open(ui);
    }
    mark(ui, "open.choose");
    if (path_line(ui, "Open", ui.open_file, "file", "open") && !ui.open_file.empty()) {
        ui.to_open.push_back(ui.open_file);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        if (i > 0) {
            ImGui::SameLine();
        }
        if (ImGui::Button(i == 0 ? "On side A alone" : "On side B alone") &&
            !ui.open_file.empty()) {
            attempt(ui, [&] { open_side(state.sides[i], lutlib::io::Look::open(ui.open_file)); });
        }
    }
    ImGui::Separator();

    const std::string recipe = usual_recipe_file(ui);
    if (path_line(ui, "Save recipe", ui.recipe_file, recipe, "save")) {
        const std::string path = path_or(ui.recipe_file, recipe);
        attempt_writing(ui, path, [&ui, path] {
            save_recipe(ui.history, path);
            ui.report = "saved " + path + "\n";
        });
    }
    const std::string lut = usual_lut_file(ui);
    if (path_line(ui, "Export LUT", ui.lut_file, lut, "export-lut")) {
        export_lut(ui, path_or(ui.lut_file, lut));
    }
    lut_controls(ui);
    ImGui::Separator();

    const std::vector<const GpuLookup*> engines = engine_lookups();
    const GpuLookup* engine = engines[ui.export_engine];
    if (ImGui::BeginCombo("Engine", std::string(engine->label).c_str())) {
        for (std::size_t i = 0; i < engines.size(); ++i) {
            if (ImGui::Selectable(std::string(engines[i]->label).c_str(), i == ui.export_engine)) {
                ui.export_engine = i;
            }
        }
        ImGui::EndCombo();
    }
    const std::string strip = usual_strip_file(ui);
    if (path_line(ui, "Export strip", ui.strip_file, strip, "export-strip")) {
        export_strip(ui, path_or(ui.strip_file, strip));
    }
    strip_controls(ui, *engine->engine);
    if (!ui.engine_folder.empty()) {
        if (ImGui::Button("Export into the engine's folder (Ctrl+E)")) {
            export_to_engine(ui);
        }
        mark(ui, "export-engine");
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", strip_in(ui.engine_folder, state).c_str());
        }
    }
    ImGui::Separator();
    const std::string picture = usual_picture_file(ui);
    if (path_line(ui, "Save picture", ui.picture_file, picture, "save-picture")) {
        save_picture(ui, path_or(ui.picture_file, picture));
    }
    constexpr int widest = 16384;
    ImGui::SliderInt("Width", &ui.picture_width, 0, widest,
                     ui.picture_width == 0 ? "as it is" : "%d",
                     ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    mark(ui, "save-picture.width");
    ImGui::Separator();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(ui.report.c_str());
    ImGui::PopTextWrapPos();
}

} // namespace preview::panels
