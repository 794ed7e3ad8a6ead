// The scopes: which of them are seen under the picture, and what of it they look at.
#include "preview/panels/look_parts.h"
#include "preview/panels/scope_region.h"
#include "preview/panels/tip.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace preview::panels {

namespace {

/// Widths in a strip: a vectorscope is square, the others share what it leaves.
std::array<float, scopes.size()> widths_in(const ScopeChoice& choice, const Rect& area) {
    std::array<float, scopes.size()> widths{};
    const auto count = static_cast<float>(std::count(choice.seen.begin(), choice.seen.end(), true));
    float left = area.width, others = 0;
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        if (!choice.seen[i]) {
            continue;
        }
        if (scopes[i].bins != ScopeBins::chroma) {
            ++others;
            continue;
        }
        widths[i] = std::floor(std::min(area.height, area.width / count));
        left -= widths[i];
    }
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        if (choice.seen[i] && widths[i] == 0) {
            widths[i] = std::floor(left / others);
        }
    }
    return widths;
}

/// Writes a scope's figures in the window's font over its picture, of ui.scopes_shown.figures.
void write_figures(const Ui& ui, const Scope& scope, const Rect& place) {
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    const std::vector<LevelFigure> levels = level_figures(scope_levels(ui));
    const ScopePlot plot = scope_plot(scope, static_cast<std::uint32_t>(place.width * scale.x),
                                      static_cast<std::uint32_t>(place.height * scale.y),
                                      ui.scopes_shown.figures, levels);
    constexpr ImU32 color = IM_COL32(184, 163, 117, 255);
    for (const ScopeLabel& label : scope_labels(scope, plot, ui.scopes_shown.figures, levels)) {
        ImGui::GetWindowDrawList()->AddText({place.x + static_cast<float>(label.x) / scale.x,
                                             place.y + static_cast<float>(label.y) / scale.y},
                                            color, label.text.data(),
                                            label.text.data() + label.text.size());
    }
}

/// Nobody shall take what was counted before for what is there now.
void write_frozen(const Rect& place) {
    constexpr const char* words = "FROZEN  F: follow again";
    constexpr ImU32 color = IM_COL32(255, 176, 32, 255);
    const ImVec2 size = ImGui::CalcTextSize(words);
    const float room = em(0.3F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRect({place.x, place.y}, {place.x + place.width, place.y + place.height}, color, 0, 0,
                 2);
    const ImVec2 low{std::max(place.x + place.width - size.x - 2 * room, place.x), place.y};
    list.AddRectFilled(low, {place.x + place.width, place.y + size.y + 2 * room}, color);
    list.AddText({low.x + room, low.y + room}, IM_COL32(0, 0, 0, 255), words);
}

/// What heights are: the shown codes, or those of an encoding.
void levels_choice(Ui& ui, ScopeChoice& choice) {
    ImGui::TextUnformatted("What their levels are");
    if (ImGui::RadioButton("the codes as they are shown", !choice.encoding)) {
        choice.encoding.reset();
    }
    mark(ui, "scope.levels.shown");
    if (ImGui::RadioButton("the same colours in another encoding", choice.encoding.has_value()) &&
        !choice.encoding) {
        choice.encoding = lutlib::encoding_named("pq");
    }
    mark(ui, "scope.levels.encoded");
    if (!choice.encoding) {
        return;
    }
    encoding_choice(ui, "Levels", "scope.levels", *choice.encoding);
    ImGui::TextWrapped("%s", levels_text(scope_levels(ui)).c_str());
    if (!shown_codes(*choice.side, *ui.history.draft().compare, ui.facts.shown_codes)) {
        ImGui::TextWrapped("%s", mixed_codes_text(ui.facts.shown_codes).c_str());
    }
}

/// How bright or high counts are.
void scale_choice(Ui& ui, ScopeChoice& choice) {
    ImGui::TextUnformatted("Their brightness and height");
    for (const ScopeScale& row : scope_scales) {
        if (ImGui::RadioButton(row.label.data(), choice.logarithmic == row.logarithmic)) {
            choice.logarithmic = row.logarithmic;
        }
        mark(ui, "scope.scale." + std::string(row.name));
    }
    const bool is_open = ImGui::BeginCombo("Gain", choice.gain->label.data());
    mark(ui, "scope.gain");
    if (!is_open) {
        return;
    }
    for (const ScopeGain& row : scope_gains) {
        if (ImGui::Selectable(row.label.data(), choice.gain == &row)) {
            choice.gain = &row;
        }
        mark(ui, "scope.gain." + std::string(row.name));
    }
    ImGui::EndCombo();
}

} // namespace

ScopeLevels scope_levels(const Ui& ui) {
    if (ui.facts.frozen_levels) {
        return *ui.facts.frozen_levels;
    }
    const State& state = ui.history.draft();
    const auto shown = shown_codes(*state.scopes_seen.side, *state.compare, ui.facts.shown_codes);
    return {state.scopes_seen.encoding, shown.value_or(lutlib::srgb()), ui.display_white};
}

void scopes_panel(Ui& ui) {
    ScopeChoice& choice = ui.history.draft().scopes_seen;
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        ImGui::Checkbox(std::string(scopes[i].label).c_str(), &choice.seen[i]);
        mark(ui, "scope." + std::string(scopes[i].name));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", std::string(scopes[i].help).c_str());
        }
    }
    if (ImGui::Button(ui.scopes_shown.are_frozen ? "Follow the picture again (F)" : "Freeze (F)")) {
        ui.scopes_shown.are_frozen = !ui.scopes_shown.are_frozen;
    }
    mark(ui, "scope.freeze");
    tip("they keep what they show while the picture changes", {}, false);
    ImGui::Separator();
    ImGui::TextUnformatted("What they measure");
    for (const ScopeSide& side : scope_sides) {
        if (ImGui::RadioButton(std::string(side.label).c_str(), choice.side == &side)) {
            choice.side = &side;
        }
        mark(ui, "scope.side." + std::string(side.name));
    }
    scope_region_controls(ui);
    levels_choice(ui, choice);
    scale_choice(ui, choice);
    ImGui::SliderFloat("Height", &choice.height, 0.15F, 0.7F, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    mark(ui, "scope.height");
}

void scope_strip(Ui& ui, const Rect& area) {
    ui.scopes_shown.places = {};
    const ScopeChoice& choice = ui.history.draft().scopes_seen;
    if (area.height < 1) {
        return;
    }
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::Begin("Scopes under the picture", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(2);
    const std::array<float, scopes.size()> widths = widths_in(choice, area);
    const ImVec2 digit = ImGui::CalcTextSize("0"), scale = ImGui::GetIO().DisplayFramebufferScale;
    ui.scopes_shown.figures = {static_cast<std::int32_t>(std::ceil(digit.x * scale.x)),
                               static_cast<std::int32_t>(std::ceil(digit.y * scale.y))};
    float x = area.x;
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        if (widths[i] < 1) {
            continue;
        }
        ui.scopes_shown.places[i] = {x, area.y, widths[i], area.height};
        ImGui::SetCursorScreenPos({x, area.y});
        ImGui::InvisibleButton(std::string(scopes[i].name).c_str(), {widths[i], area.height});
        mark(ui, "scope.seen." + std::string(scopes[i].name));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s: %s", std::string(scopes[i].label).c_str(),
                              std::string(scopes[i].help).c_str());
        }
        write_figures(ui, scopes[i], ui.scopes_shown.places[i]);
        if (ui.scopes_shown.are_frozen) {
            write_frozen(ui.scopes_shown.places[i]);
        }
        x += widths[i];
    }
    if (!ui.facts.no_scopes.empty()) {
        ImGui::SetCursorScreenPos({area.x + em(0.86F), area.y + em(0.57F)});
        ImGui::TextDisabled("%s", ui.facts.no_scopes.c_str());
    }
    ImGui::End();
}

} // namespace preview::panels
