// What is compared, and how the picture is made.
#include "preview/editor/commands.h"
#include "preview/panels/ui.h"

#include <imgui.h>

namespace preview::ui {

namespace {

std::string text_of(std::string_view view) {
    return std::string(view);
}

/// A list of a table's labels.
template <class Rows, class Row>
void row_choice(Ui& ui, const char* title, const Rows& rows, const Row*& chosen) {
    const bool open = ImGui::BeginCombo(title, text_of(chosen->label).c_str());
    mark(ui, title);
    if (!open)
        return;
    for (const Row& row : rows)
        if (ImGui::Selectable(text_of(row.label).c_str(), &row == chosen))
            chosen = &row;
    ImGui::EndCombo();
}

void side_controls(Ui& ui, Side& side, const std::string& name, const std::string& note) {
    ImGui::PushID(name.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(("Side " + name).c_str());
    for (const SideSourceInfo& info : side_sources) {
        ImGui::SameLine();
        ImGui::BeginDisabled(info.source == SideSource::file && !side.lut);
        if (ImGui::RadioButton(text_of(info.name).c_str(), side.source == info.source))
            side.source = info.source;
        ImGui::EndDisabled();
        mark(ui, "side" + name + "." + text_of(info.name));
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%.*s", static_cast<int>(info.help.size()), info.help.data());
    }
    if (side.source == SideSource::recipe)
        ImGui::TextDisabled("%s",
                            note.empty() ? "being measured against the recipe ..." : note.c_str());
    if (side.source == SideSource::file)
        ImGui::TextDisabled("%s", side.path.c_str());
    if (side.source == SideSource::file)
        lines(side.told);
    if (side.source == SideSource::baked) {
        if (ImGui::BeginCombo("Engine", text_of(side.engine->label).c_str())) {
            for (const GpuLookup* row : engine_lookups())
                if (ImGui::Selectable(text_of(row->label).c_str(), row == side.engine)) {
                    side.engine = row;
                    side.size = side.bits = 0;
                }
            ImGui::EndCombo();
        }
        const lutlib::Engine& engine = *side.engine->engine;
        ImGui::TextDisabled("%d nodes a side, %d bits",
                            side.size > 0 ? side.size : engine.default_size,
                            side.bits > 0 ? side.bits : engine.default_bits);
    }
    ImGui::PopID();
}

} // namespace

void view_panel(Ui& ui) {
    State& state = ui.history.draft();
    row_choice(ui, "Compare", compares, state.compare);
    side_controls(ui, state.sides[0], "A", ui.facts.look_notes[0]);
    side_controls(ui, state.sides[1], "B", ui.facts.look_notes[1]);
    if (state.compare == &compare_difference) {
        ImGui::SliderFloat("Heat map to dE2000", &state.heat_scale, 4, 96, "%.0f",
                           ImGuiSliderFlags_AlwaysClamp);
        if (ui.facts.measured.figures)
            ImGui::Text("dE2000: mean %.3f, p95 %.3f, p99 %.3f, max %.3f",
                        ui.facts.measured.figures->mean, ui.facts.measured.figures->p95,
                        ui.facts.measured.figures->p99, ui.facts.measured.figures->max);
    } else {
        ImGui::SliderFloat("Split", &state.split, 0, 1, "%.3f", ImGuiSliderFlags_AlwaysClamp);
    }
    ImGui::Separator();
    ImGui::TextDisabled("%s on %s", ui.facts.input.c_str(), ui.facts.device.c_str());
    ImGui::SliderFloat("Exposure (stops)", &state.exposure, -8, 8, "%.2f");
    ImGui::BeginDisabled(ui.facts.display_encoded);
    row_choice(ui, "Tone map", tonemaps(), state.tonemap);
    row_choice(ui, "Bloom", blooms(), state.bloom);
    if (state.bloom->strength > 0) {
        float strength = state.bloom_settings.strength < 0 ? state.bloom->strength
                                                           : state.bloom_settings.strength;
        if (ImGui::SliderFloat("Bloom strength", &strength, 0, 1, "%.3f",
                               ImGuiSliderFlags_AlwaysClamp))
            state.bloom_settings.strength = strength;
        ImGui::SliderFloat("Bloom threshold", &state.bloom_settings.threshold, 0, 16, "%.2f",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
        ImGui::SliderFloat("Bloom radius", &state.bloom_settings.radius, 0.05F, 8, "%.2f",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
    }
    ImGui::EndDisabled();
    if (ui.facts.is_scene) {
        ImGui::Separator();
        ImGui::SliderFloat("Azimuth", &state.orbit.azimuth, -180, 180, "%.1f");
        ImGui::SliderFloat("Elevation", &state.orbit.elevation, -89, 89, "%.1f");
        ImGui::SliderFloat("Distance (m)", &state.orbit.distance, 0.2F, 50, "%.2f",
                           ImGuiSliderFlags_Logarithmic);
        ImGui::SliderFloat("Field of view", &state.orbit.field_of_view, 10, 120, "%.1f");
    }
}

} // namespace preview::ui
