// What can be changed of a light, as a table: the command line and the panel follow it.
#pragma once

#include "preview/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace preview {

struct LightControl {
    enum class Kind : std::uint8_t { flag, number, color, point };

    std::string_view name;
    std::string_view label;
    std::string_view help;
    std::string_view unit;
    Kind kind;
    float min = 0, max = 1; ///< of every component, both included
    bool logarithmic = false;
    /// Flags are 0 or 1; those and numbers are in x.
    glm::vec3 (*get)(const PointLight& light);
    void (*set)(PointLight& light, glm::vec3 value);
    /// Why it changes nothing of such a light, while shadows fall or are switched off; empty: it
    /// does. Null: it always does.
    std::string_view (*idle_because)(const PointLight& light, bool shadows_fall) = nullptr;
};

std::span<const LightControl> light_controls();

/// Why the control changes nothing of what is seen of this light, as of one that is off; empty: it
/// does.
std::string_view idle_because(const LightControl& control, const PointLight& light,
                              bool shadows_fall);

/// How many of a value's components its kind has.
constexpr int components(LightControl::Kind kind) {
    return kind == LightControl::Kind::color || kind == LightControl::Kind::point ? 3 : 1;
}

/// What people call the light: its name, or its number in the scene.
std::string light_name(const PointLight& light, std::size_t index);

} // namespace preview
