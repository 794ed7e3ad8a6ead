#include "preview/panels/still_controls.h"

#include "preview/editor/stills.h"
#include "preview/finish/fit.h"
#include "preview/panels/searched_list.h"
#include "preview/panels/seen.h"
#include "preview/panels/tip.h"

#include <imgui.h>

namespace preview::panels {

namespace {

/// What the file's numbers are decoded by, in place of what they are taken for.
void encoding_choice(Ui& ui, Side& side, const std::string& place) {
    const std::string path = side.still->path;
    bool is_said = side.still->said.has_value();
    if (ImGui::Checkbox("Convert it from another encoding", &is_said)) {
        attempt(ui, [&] {
            side.still = load_still(path, is_said ? std::optional(lutlib::srgb())
                                                  : std::optional<lutlib::Encoding>());
        });
    }
    mark(ui, place + ".convert");
    if (!side.still->said) {
        return;
    }
    const lutlib::Encoding said = *side.still->said;
    const lutlib::TransferCurve* curve = said.curve;
    if (searched_choice(ui, "Curve", place + ".curve", lutlib::transfer_curves(), curve)) {
        attempt(ui, [&] { side.still = load_still(path, lutlib::Encoding{curve, curve->gamut}); });
    }
    const lutlib::Gamut* gamut = said.gamut;
    if (searched_choice(ui, "Gamut", place + ".gamut", lutlib::gamuts(), gamut)) {
        attempt(ui, [&] {
            side.still = load_still(path, lutlib::Encoding{side.still->said->curve, gamut});
        });
    }
}

} // namespace

void open_still(Ui& ui, std::size_t side, const std::string& path) {
    show_still(ui.history.draft(), side, load_still(path));
    remember_file(ui.recent, path);
}

void ask_for_still(Ui& ui, std::size_t side) {
    ask_for_file(ui, {.title = "Open a reference still",
                      .button = "Open",
                      .chosen = [&ui, side](const std::string& path) {
                          attempt(ui, [&] { open_still(ui, side, path); });
                      }});
}

void still_notes(Ui& ui, const Still& still, const std::string& place) {
    ImGui::TextDisabled("%s", still.path.c_str());
    ImGui::TextWrapped("%s", still.shown_as.c_str());
    const std::string fit = fit_text(still.size, seen_in(ui, ui.picture_place).own);
    if (!fit.empty()) {
        ImGui::TextWrapped("%s", fit.c_str());
    }
    told_lines(ui, still.told, place + ".told.");
}

void still_controls(Ui& ui) {
    State& state = ui.history.draft();
    ImGui::TextWrapped("A reference still is any picture, shown on a side as it is. Drop one here, "
                       "or open it.");
    for (std::size_t i = 0; i < state.sides.size(); ++i) {
        const std::string name(1, static_cast<char>('A' + i));
        ImGui::PushID(name.c_str());
        if (ImGui::Button(("Open a still on side " + name).c_str())) {
            ask_for_still(ui, i);
        }
        mark(ui, "still." + name);
        if (state.sides[i].still) {
            ImGui::SameLine();
            if (ImGui::Button("Take it off")) {
                take_still_off(state, i);
            }
            mark(ui, "still." + name + ".off");
        }
        if (state.sides[i].still) {
            still_notes(ui, *state.sides[i].still, "still." + name);
            encoding_choice(ui, state.sides[i], "still." + name);
        }
        ImGui::PopID();
    }
}

bool takes_dropped_stills(const Ui& ui, float x, float y) {
    const std::vector<std::string> names = panel_names();
    const auto panels = ui.places.find("panels");
    return names[ui.panel] == "Versions" && panels != ui.places.end() && x >= panels->second.x &&
           x < panels->second.x + panels->second.width && y >= panels->second.y &&
           y < panels->second.y + panels->second.height;
}

} // namespace preview::panels
