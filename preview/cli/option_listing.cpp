#include "preview/cli/option_listing.h"

#include "preview/cli/light_edit.h"
#include "preview/cli/option_rows.h"
#include "preview/effects/effect.h"
#include "preview/look/cube_settings.h"
#include "preview/look/gpu_lookups.h"

#include <fmt/format.h>

namespace preview {

namespace {

std::string line_of(std::string_view name, std::string_view text) {
    return fmt::format("  {:<20} {}\n", name, text);
}

template <class Rows>
std::string section(std::string_view title, const Rows& rows) {
    std::string out = fmt::format("{}\n", title);
    for (const auto& row : rows) {
        out += line_of(row.name, text_of(row));
    }
    return out;
}

template <class S>
std::string section_of(const ChoiceRow<S>& row) {
    std::string out = fmt::format("{} (--{})\n", row.title, row.flag);
    for (const Option& option : row.options()) {
        out += line_of(option.name, option.text);
    }
    return out;
}

template <class S>
std::string section_of(std::string_view title, std::span<const NumberRow<S>> rows) {
    const S usual;
    std::string out = fmt::format("{}\n", title);
    for (const NumberRow<S>& row : rows) {
        // The help of one that stands for something says so.
        const std::string fallback =
            row.is_own(usual) ? "" : fmt::format(", by default {}", row.value(usual));
        out += line_of(fmt::format("--{}", row.flag),
                       fmt::format("{}; {} to {}{}", row.help, row.min, row.max, fallback));
    }
    return out;
}

std::string camera_listing() {
    std::string out = "Camera\n";
    for (const NumberRow<Orbit>& row : camera_numbers()) {
        out += line_of(fmt::format("--{}", row.flag),
                       fmt::format("{}; {} to {}, added to the scene's", row.help, -reach_of(row),
                                   reach_of(row)));
    }
    return out;
}

std::string surroundings_listing() {
    std::string out = section("Surroundings (--surroundings)", surroundings_kinds());
    for (const NumberRow<Surroundings>& row : surroundings_numbers()) {
        out += line_of(
            fmt::format("--{}", row.flag),
            fmt::format("{}; {} to {}, by default the scene's", row.help, row.min, row.max));
    }
    return out;
}

std::string cube_listing() {
    std::string out = section_of("Cube view", cube_numbers());
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        out += line_of(fmt::format("--{}", row.flag), row.help);
    }
    return out;
}

std::string effects_listing() {
    std::string out = "Effects (--effect); h is the picture's height\n";
    for (const PostEffect* effect : post_effects()) {
        out += line_of(
            effect->name,
            fmt::format("{}; {}{}", effect->help,
                        stages()[static_cast<std::size_t>(effect->stage)].help,
                        can_stand_before_look(*effect) ? ", or before with before-look=1" : ""));
        for (const lutlib::Parameter& parameter : effect->parameters) {
            out += line_of(fmt::format("  {}", parameter.name),
                           fmt::format("{}{}; {} to {}, by default {}", parameter.label,
                                       parameter.unit.empty() ? std::string()
                                                              : fmt::format(", {}", parameter.unit),
                                       parameter.min, parameter.max, parameter.fallback));
        }
    }
    return out;
}

} // namespace

std::string listing() {
    std::string out = section("Scenes", scenes()) + section("Lookups (--engine)", gpu_lookups());
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        out += section_of(row);
    }
    for (const ChoiceRow<Options>& row : option_choices()) {
        out += section_of(row);
    }
    return out + section_of("Settings", picture_numbers()) + camera_listing() +
           surroundings_listing() + cube_listing() + effects_listing() +
           section("Parts of the frame (--without, as effects)", effects) +
           section("Lights' controls (--light)", light_controls());
}

} // namespace preview
