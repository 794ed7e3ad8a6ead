#include "preview/cli/option_listing.h"

#include "preview/cli/light_edit.h"
#include "preview/cli/option_rows.h"
#include "preview/effects/effect.h"
#include "preview/look/cube_settings.h"
#include "preview/look/gpu_lookups.h"

#include <fmt/format.h>

namespace preview {

namespace {

using terminal::Table;

void add(Table& table, std::string_view name, std::string_view text) {
    table.row({std::string(name), std::string(text)});
}

template <class Rows>
void add_section(Table& table, std::string_view title, const Rows& rows) {
    table.heading(std::string(title));
    for (const auto& row : rows) {
        add(table, row.name, text_of(row));
    }
}

template <class S>
void add_section(Table& table, const ChoiceRow<S>& row) {
    table.heading(fmt::format("{} (--{})", row.title, row.flag));
    for (const Option& option : row.options()) {
        add(table, option.name, option.text);
    }
}

template <class S>
void add_numbers(Table& table, std::string_view title, std::span<const NumberRow<S>> rows) {
    const S usual;
    table.heading(std::string(title));
    for (const NumberRow<S>& row : rows) {
        // The help of one that stands for something says so.
        const std::string fallback =
            row.is_own(usual) ? "" : fmt::format(", by default {}", row.value(usual));
        add(table, fmt::format("--{}", row.flag),
            fmt::format("{}; {} to {}{}", row.help, row.min, row.max, fallback));
    }
}

void add_camera(Table& table) {
    table.heading("Camera");
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        add(table, fmt::format("--{}", row.flag),
            fmt::format("{}; {} to {}, added to the scene's", row.help, -reach_of(row),
                        reach_of(row)));
    }
}

void add_surroundings(Table& table) {
    add_section(table, "Surroundings (--surroundings)", surroundings_kinds());
    for (const NumberRow<Surroundings>& row : surroundings_numbers()) {
        add(table, fmt::format("--{}", row.flag),
            fmt::format("{}; {} to {}, by default the scene's", row.help, row.min, row.max));
    }
}

void add_cube(Table& table) {
    add_numbers(table, "Cube view", cube_numbers());
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        add(table, fmt::format("--{}", row.flag), row.help);
    }
}

void add_effects(Table& table) {
    table.heading("Effects (--effect); h is the picture's height");
    for (const PostEffect* effect : post_effects()) {
        add(table, effect->name,
            fmt::format("{}; {}{}", effect->help,
                        stages()[static_cast<std::size_t>(effect->stage)].help,
                        can_stand_before_look(*effect) ? ", or before with before-look=1" : ""));
        for (const lutlib::Parameter& parameter : effect->parameters) {
            add(table, fmt::format("  {}", parameter.name),
                fmt::format("{}{}; {} to {}, by default {}", parameter.label,
                            parameter.unit.empty() ? std::string()
                                                   : fmt::format(", {}", parameter.unit),
                            parameter.min, parameter.max, parameter.fallback));
        }
    }
}

} // namespace

Table listing() {
    Table out;
    add_section(out, "Scenes", scenes());
    add_section(out, "Lookups (--engine)", gpu_lookups());
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        add_section(out, row);
    }
    for (const ChoiceRow<Options>& row : option_choices()) {
        add_section(out, row);
    }
    add_numbers(out, "Settings", picture_numbers());
    add_camera(out);
    add_surroundings(out);
    add_cube(out);
    add_effects(out);
    add_section(out, "Parts of the frame (--without, as effects)", effects);
    add_section(out, "Lights' controls (--light)", light_controls());
    return out;
}

} // namespace preview
