// What the picture's and the look's codes are, and where looks stand.
#include "preview/look/look_file.h"
#include "preview/panels/look_parts.h"
#include "preview/panels/searched_list.h"
#include "preview/panels/tip.h"

namespace preview::panels {

namespace {

void where_looks_stand(Ui& ui, PictureCodes& picture) {
    const bool open = ImGui::BeginCombo("Place", std::string(picture.at->name).c_str());
    mark(ui, "look.at");
    if (!open) {
        return;
    }
    for (const LookAt& row : look_ats) {
        if (ImGui::Selectable(std::string(row.name).c_str(), &row == picture.at)) {
            picture.at = &row;
        }
        mark(ui, "look.at." + std::string(row.name));
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", std::string(row.help).c_str());
        }
    }
    ImGui::EndCombo();
}

} // namespace

void encoding_choice(Ui& ui, const std::string& label, const std::string& place,
                     lutlib::Encoding& chosen) {
    const lutlib::TransferCurve* curve = chosen.curve;
    if (searched_choice(ui, label + " curve", place + ".curve", lutlib::transfer_curves(), curve)) {
        chosen = {curve, curve->gamut};
    }
    const lutlib::Gamut* gamut = chosen.gamut;
    if (searched_choice(ui, label + " gamut", place + ".gamut", lutlib::gamuts(), gamut)) {
        chosen.gamut = gamut;
    }
}

void encodings_of_look(Ui& ui) {
    State& state = ui.history.draft();
    lutlib::Recipe& recipe = state.recipe;
    const std::string heading = "Encodings: " + recipe.input.name() + " to " +
                                recipe.output_encoding().name() + "###encodings";
    const bool is_open = ImGui::CollapsingHeader(heading.c_str());
    mark(ui, "look.encodings");
    tip("What the picture's codes are, what the look takes and gives, and where it stands", {},
        false);
    if (!is_open) {
        return;
    }
    encoding_choice(ui, "Picture", "look.picture", state.picture.encoding);
    encoding_choice(ui, "Input", "look.input", recipe.input);
    lutlib::Encoding output = recipe.output_encoding();
    encoding_choice(ui, "Output", "look.output", output);
    if (output != recipe.output_encoding()) {
        recipe.output = output;
    }
    ImGui::Checkbox("Convert between the picture's encoding and the look's",
                    &state.picture.convert);
    mark(ui, "look.convert");
    where_looks_stand(ui, state.picture);
}

} // namespace preview::panels
