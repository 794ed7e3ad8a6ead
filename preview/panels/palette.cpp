#include "preview/panels/palette.h"

#include "preview/editor/search.h"
#include "preview/editor/stills.h"
#include "preview/effects/effect.h"
#include "preview/panels/still_controls.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace preview::panels {

namespace {

void add(std::vector<Action>& out, std::string text, std::function<void(Ui&)> act) {
    out.push_back({.help = std::move(text), .act = std::move(act)});
}

void add_choices(std::vector<Action>& out) {
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        const std::vector<Option> options = row.options();
        for (std::size_t i = 0; i < options.size(); ++i) {
            add(out,
                std::string(row.label) + ": " + std::string(options[i].name) + ", " +
                    std::string(options[i].text),
                [&row, i](Ui& ui) { row.choose(ui.history.draft(), i); });
        }
    }
}

void add_zooms(std::vector<Action>& out) {
    for (const ZoomStep& step : zoom_steps) {
        add(out, "zoom: " + std::string(step.label), [&step](Ui& ui) { zoom_to(ui, step.scale); });
    }
}

void add_scopes(std::vector<Action>& out) {
    for (const ScopeGain& row : scope_gains) {
        add(out, "scope gain: " + std::string(row.label),
            [&row](Ui& ui) { ui.history.draft().scopes_seen.gain = &row; });
    }
    add(out, "scope levels: the codes as they are shown",
        [](Ui& ui) { ui.history.draft().scopes_seen.encoding.reset(); });
    for (const lutlib::Encoding& row : lutlib::encodings()) {
        add(out, "scope levels: " + row.label() + " (" + row.name() + ")",
            [&row](Ui& ui) { ui.history.draft().scopes_seen.encoding = row; });
    }
}

void add_switches(std::vector<Action>& out) {
    for (const PostEffect* effect : post_effects()) {
        add(out, "effect on or off: " + std::string(effect->label), [effect](Ui& ui) {
            EffectUses& uses = ui.history.draft().effects;
            use_of(uses, *effect) == nullptr ? put_use(uses, usual_use(*effect))
                                             : take_out(uses, *effect);
        });
    }
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        add(out, "scope seen or not: " + std::string(scopes[i].label), [i](Ui& ui) {
            bool& is_seen = ui.history.draft().scopes_seen.seen[i];
            is_seen = !is_seen;
        });
    }
    for (const std::size_t side : {0U, 1U}) {
        const std::string name(1, static_cast<char>('A' + side));
        add(out, "open a reference still on side " + name,
            [side](Ui& ui) { ask_for_still(ui, side); });
        add(out, "take the still off side " + name,
            [side](Ui& ui) { take_still_off(ui.history.draft(), side); });
    }
    add(out, "scopes: drag the region that they count", [](Ui& ui) { ui.region_drag.emplace(); });
    add(out, "scopes: count all of the picture",
        [](Ui& ui) { ui.history.draft().scopes_seen.region = {}; });
    for (const EffectInfo& row : effects) {
        add(out, "part of the frame on or off: " + std::string(row.label), [&row](Ui& ui) {
            EffectSet& without = ui.history.draft().without;
            without.set(row.effect, !without.has(row.effect));
        });
    }
}

/// What the keys do to the place of the chosen row.
std::size_t moved(std::size_t at, std::size_t count) {
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    if (count == 0) {
        return 0;
    }
    at = std::min(at, count - 1);
    if (pressed(ImGuiKey_DownArrow)) {
        return (at + 1) % count;
    }
    return pressed(ImGuiKey_UpArrow) ? (at + count - 1) % count : at;
}

} // namespace

std::vector<Action> commands() {
    std::vector<Action> out = actions();
    const std::vector<std::string> names = panel_names();
    for (std::size_t i = 0; i < names.size(); ++i) {
        add(out, "panel: " + names[i], [i](Ui& ui) { ui.panel = i; });
    }
    add_choices(out);
    add_zooms(out);
    add_switches(out);
    add_scopes(out);
    return out;
}

std::vector<std::size_t> found_commands(const std::vector<Action>& all, const std::string& typed) {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (is_found(all[i].help + " " + keys_of(all[i]), typed)) {
            out.push_back(i);
        }
    }
    return out;
}

void palette(Ui& ui) {
    if (!ui.shows_palette) {
        return;
    }
    static const std::vector<Action> all = commands();
    constexpr std::size_t most_rows = 14;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float width = std::min(em(44), room.x - em(1));
    ImGui::SetNextWindowPos({room.x / 2, em(2)}, ImGuiCond_Always, {0.5F, 0});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::Begin("What to do", nullptr,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::IsWindowAppearing()) {
        ui.palette_text.clear();
        ui.palette_at = 0;
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    const std::string before = ui.palette_text;
    const bool entered =
        ImGui::InputTextWithHint("##typed", "type what you want to do, Enter does it",
                                 &ui.palette_text, ImGuiInputTextFlags_EnterReturnsTrue);
    mark(ui, "palette.search");
    const std::vector<std::size_t> found = found_commands(all, ui.palette_text);
    const bool is_moved = ui.palette_text == before;
    ui.palette_at = is_moved ? moved(ui.palette_at, found.size()) : 0;
    const float height =
        ImGui::GetTextLineHeightWithSpacing() *
        static_cast<float>(std::min(std::max(found.size(), std::size_t{1}), most_rows));
    const Action* chosen = nullptr;
    ImGui::BeginChild("found", {0, std::min(height, std::max(room.y - em(8), em(2)))});
    for (std::size_t row = 0; row < found.size(); ++row) {
        const Action& action = all[found[row]];
        ImGui::PushID(static_cast<int>(row));
        if (ImGui::Selectable(action.help.c_str(), row == ui.palette_at)) {
            chosen = &action;
        }
        if (row < most_rows) {
            mark(ui, "palette." + std::to_string(row));
        }
        if (row == ui.palette_at && !ImGui::IsItemVisible()) {
            ImGui::SetScrollHereY();
        }
        const std::string keys = keys_of(action);
        if (!keys.empty()) {
            ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(keys.c_str()).x);
            ImGui::TextDisabled("%s", keys.c_str());
        }
        ImGui::PopID();
    }
    if (found.empty()) {
        ImGui::TextDisabled("nothing has all these words");
    }
    ImGui::EndChild();
    ImGui::End();
    if (entered && ui.palette_at < found.size()) {
        chosen = &all[found[ui.palette_at]];
    }
    if (chosen != nullptr) {
        ui.shows_palette = false;
        chosen->act(ui);
    }
}

} // namespace preview::panels
