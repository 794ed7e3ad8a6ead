// What is compared, and how the picture is made.
#include "preview/editor/commands.h"
#include "preview/effects/effect.h"
#include "preview/panels/eyedropper.h"
#include "preview/panels/file_dialog.h"
#include "preview/panels/parameter_control.h"
#include "preview/panels/still_controls.h"
#include "preview/panels/tip.h"
#include "preview/panels/ui.h"
#include "preview/scene/camera_settings.h"

#include <imgui.h>

namespace preview::panels {

namespace {

void choice(Ui& ui, std::string_view flag) {
    const ChoiceRow<PictureSettings>& row = picture_choice(flag);
    PictureSettings& settings = ui.history.draft();
    const std::vector<Option> options = row.options();
    const std::size_t chosen = row.chosen(settings);
    const bool open = ImGui::BeginCombo(std::string(row.label).c_str(),
                                        std::string(options[chosen].text).c_str());
    mark(ui, std::string(row.label));
    if (!open) {
        return;
    }
    for (std::size_t i = 0; i < options.size(); ++i) {
        if (ImGui::Selectable(std::string(options[i].text).c_str(), i == chosen)) {
            row.choose(settings, i);
        }
    }
    ImGui::EndCombo();
}

/// What is usual, with its unit.
template <class S>
std::string usual_text(const NumberRow<S>& row, const S& usual) {
    return number_text(row.value(usual), row.is_own(usual) ? row.own_name : "") +
           (row.unit.empty() ? "" : " " + std::string(row.unit));
}

template <class S>
void number(Ui& ui, const NumberRow<S>& row, S& settings, const S& usual = {}) {
    const bool has_own_range = row.slider_min < row.slider_max;
    const std::string label =
        std::string(row.label) + (row.unit.empty() ? "" : " (" + std::string(row.unit) + ")");
    float value = row.value(settings);
    if (ImGui::SliderFloat(
            label.c_str(), &value, static_cast<float>(has_own_range ? row.slider_min : row.min),
            static_cast<float>(has_own_range ? row.slider_max : row.max), "%.4g",
            ImGuiSliderFlags_AlwaysClamp |
                (row.is_logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None))) {
        row.of(settings) = value;
    }
    mark(ui, "setting." + std::string(row.flag));
    tip(row.help, usual_text(row, usual));
}

void number(Ui& ui, std::string_view flag) {
    number<PictureSettings>(ui, picture_number(flag), ui.history.draft());
}

// Those whose flags begin so.
void numbers_of(Ui& ui, std::string_view beginning) {
    for (const NumberRow<PictureSettings>& row : picture_numbers()) {
        if (row.flag.starts_with(beginning)) {
            number<PictureSettings>(ui, row, ui.history.draft());
        }
    }
}

void bloom_controls(Ui& ui) {
    choice(ui, "bloom");
    if (ui.history.draft().bloom->strength <= 0) {
        return;
    }
    numbers_of(ui, "bloom-");
}

/// The exposure by what the picture shows.
void metering(Ui& ui) {
    if (ImGui::Button("Meter")) {
        ui.metering = Metering{};
    }
    mark(ui, "meter");
    tip("The exposure with which the picture's mean, in stops, is 18 % grey", {}, false);
    ImGui::SameLine();
    if (pick_button(ui, "Meter a place", "The exposure with which what is clicked is 18 % grey",
                    "meter.pick")) {
        start_metering(ui);
    }
}

/// A switch for every effect, with the parameters of those in use.
void effect_controls(Ui& ui) {
    EffectUses& uses = ui.history.draft().effects;
    for (const PostEffect* effect : post_effects()) {
        const std::string name(effect->name);
        const EffectUse* const use = use_of(uses, *effect);
        bool is_on = use != nullptr;
        if (ImGui::Checkbox(std::string(effect->label).c_str(), &is_on)) {
            is_on ? put_use(uses, usual_use(*effect)) : take_out(uses, *effect);
        }
        mark(ui, "effect." + name);
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", std::string(effect->help).c_str());
        }
        if (!is_on || use == nullptr) {
            continue;
        }
        ImGui::PushID(name.c_str());
        EffectUse changed = *use;
        bool is_changed = false;
        for (std::size_t i = 0; i < changed.values.size(); ++i) {
            const lutlib::Parameter& parameter = effect->parameters[i];
            is_changed |= parameter_control(ui, parameter, changed.values[i],
                                            "effect." + name + "." + std::string(parameter.name));
        }
        if (can_stand_before_look(*effect)) {
            is_changed |= ImGui::Checkbox("Before the looks", &changed.before_look);
            mark(ui, "effect." + name + ".before-look");
        }
        ImGui::PopID();
        if (is_changed) {
            put_use(uses, std::move(changed));
        }
    }
}

void side_controls(Ui& ui, Side& side, const std::string& name, const std::string& note,
                   const std::string& standing) {
    ImGui::PushID(name.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(("Side " + name).c_str());
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (const SideSourceInfo& info : side_sources) {
        const float width = ImGui::CalcTextSize(info.name.data()).x + ImGui::GetFrameHeight() +
                            2 * ImGui::GetStyle().ItemSpacing.x;
        if (ImGui::GetItemRectMax().x + width < right) {
            ImGui::SameLine();
        }
        ImGui::BeginDisabled((info.source == SideSource::file && !side.lut) ||
                             (info.source == SideSource::version && !side.version) ||
                             (info.source == SideSource::still && !side.still));
        if (ImGui::RadioButton(std::string(info.name).c_str(), side.source == info.source)) {
            side.source = info.source;
        }
        ImGui::EndDisabled();
        mark(ui, "side" + name + "." + std::string(info.name));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%.*s", static_cast<int>(info.help.size()), info.help.data());
        }
    }
    if (side.source == SideSource::recipe) {
        ImGui::TextDisabled("%s",
                            note.empty() ? "being measured against the recipe ..." : note.c_str());
    }
    if (!standing.empty()) {
        ImGui::TextWrapped("%s", standing.c_str());
    }
    if (side.source == SideSource::file) {
        ImGui::TextDisabled("%s", side.path.c_str());
    }
    if (side.source == SideSource::file) {
        lines(side.told);
    }
    if (side.source == SideSource::still && side.still) {
        still_notes(ui, *side.still, "side" + name + ".still");
    }
    if (side.source == SideSource::baked) {
        if (ImGui::BeginCombo("Engine", std::string(side.engine->label).c_str())) {
            for (const GpuLookup* row : engine_lookups()) {
                if (ImGui::Selectable(std::string(row->label).c_str(), row == side.engine)) {
                    side.engine = row;
                    side.size = side.bits = 0;
                }
            }
            ImGui::EndCombo();
        }
        const lutlib::Engine& engine = *side.engine->engine;
        ImGui::TextDisabled("%d nodes per axis, %d bits",
                            side.size > 0 ? side.size : engine.default_size,
                            side.bits > 0 ? side.bits : engine.default_bits);
    }
    ImGui::PopID();
}

/// What stands around the scene.
void surroundings_controls(Ui& ui, Surroundings& surroundings) {
    const auto kinds = surroundings_kinds();
    const SurroundingsInfo& chosen = kinds[static_cast<std::size_t>(surroundings.kind)];
    const bool open = ImGui::BeginCombo("Surroundings", std::string(chosen.help).c_str());
    mark(ui, "Surroundings");
    if (open) {
        for (const SurroundingsInfo& row : kinds) {
            const bool is_there =
                row.kind != SurroundingsKind::picture || ui.facts.has_surroundings_picture;
            if (is_there && ImGui::Selectable(std::string(row.help).c_str(), &row == &chosen)) {
                surroundings.kind = row.kind;
            }
        }
        ImGui::EndCombo();
    }
    if (ImGui::Button("Open a picture of them ...")) {
        ask_for_surroundings(ui);
    }
    mark(ui, "surroundings.open");
    tip("An equirectangular picture of all directions, as an .exr or .hdr of a sky", {}, false);
    for (const NumberRow<Surroundings>& row : chosen.numbers) {
        number(ui, row, surroundings);
    }
    told_lines(ui, ui.facts.surroundings_told, "surroundings.told.");
}

/// How large the picture's pixels are seen.
void zoom_controls(Ui& ui) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Zoom");
    for (const ZoomStep& step : zoom_steps) {
        ImGui::SameLine();
        if (ImGui::RadioButton(step.label.data(), ui.history.draft().zoom.scale == step.scale)) {
            zoom_to(ui, step.scale);
        }
        mark(ui, "zoom." + std::string(step.label));
    }
    if (ui.history.draft().zoom.scale > 0) {
        number(ui, "zoom");
        choice(ui, "magnify");
    }
}

} // namespace

void start_metering(Ui& ui) {
    // Not by what was measured of the shown picture: that is rounded at its exposure, and each time
    // moves it a little.
    start_pick(ui, "Click what shall be 18 % grey",
               [](Ui& at, const Probe& /*probe*/) { at.metering = Metering{at.pointer}; });
}

void ask_for_surroundings(Ui& ui) {
    ask_for_file(ui, {.title = "Surround the scene with",
                      .button = "Open",
                      .chosen = [&ui](const std::string& path) { ui.surround_with = path; }});
}

void view_panel(Ui& ui) {
    State& state = ui.history.draft();
    choice(ui, "compare");
    side_controls(ui, state.sides[0], "A", ui.facts.look_notes[0], ui.facts.look_standings[0]);
    side_controls(ui, state.sides[1], "B", ui.facts.look_notes[1], ui.facts.look_standings[1]);
    if (state.compare == &compare_difference) {
        number(ui, "heat-scale");
        if (ui.facts.measured.figures) {
            ImGui::Text("dE2000: mean %.3f, p95 %.3f, p99 %.3f, max %.3f",
                        ui.facts.measured.figures->mean, ui.facts.measured.figures->p95,
                        ui.facts.measured.figures->p99, ui.facts.measured.figures->max);
        }
    } else {
        numbers_of(ui, state.compare == &compare_box ? "box-" : "split");
    }
    ImGui::BeginDisabled(state.compare == &compare_difference);
    choice(ui, "view");
    if (state.picture_view == picture_view_named("zebra")) {
        number(ui, "zebra-level");
    }
    ImGui::EndDisabled();
    zoom_controls(ui);
    ImGui::Separator();
    ImGui::TextDisabled("%s on %s", ui.facts.input.c_str(), ui.facts.device.c_str());
    number(ui, "exposure");
    ImGui::BeginDisabled(ui.facts.display_encoded);
    metering(ui);
    choice(ui, "tonemap");
    bloom_controls(ui);
    ImGui::EndDisabled();
    if (ui.facts.is_scene) {
        choice(ui, "shadow-filter");
        numbers_of(ui, "occlusion-");
        choice(ui, "occlusion-resolution");
    }
    ImGui::Separator();
    effect_controls(ui);
    if (ui.facts.is_scene) {
        ImGui::Separator();
        for (const NumberRow<Orbit>& row : camera_numbers()) {
            number(ui, row, state.orbit, ui.facts.usual_orbit);
        }
        ImGui::Separator();
        surroundings_controls(ui, state.surroundings);
    }
}

} // namespace preview::panels
