// What stands around a scene: its own gradient with soft boxes (environment.h), a sky, a picture of
// all directions, or the gradient with noise in front of it where no surface is. Its numbers are
// rows, which flags, sliders and --explain are made from.
#pragma once

#include "preview/finish/setting_rows.h"
#include "preview/scene/sky.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace preview {

enum class SurroundingsKind : std::uint8_t { gradient, sky, picture, noise };

struct Surroundings {
    SurroundingsKind kind = SurroundingsKind::gradient;
    Sky sky;
    float exposure = 0;        ///< stops, of a sky or picture
    float rotation = 0;        ///< of a picture to the right, degrees
    float noise_hue = 210;     ///< at time 0, degrees
    float noise_value = 0.35F; ///< of HSV, as a display code
    float noise_scale = 4;     ///< how fine the noise is
    double seconds = 0;        ///< the moment, which moves hue and noise
    friend bool operator==(const Surroundings&, const Surroundings&) = default;
};

struct SurroundingsInfo {
    SurroundingsKind kind;
    std::string_view name;
    std::string_view help;
    std::span<const NumberRow<Surroundings>> numbers; ///< that this kind has
};

/// In the order of the enumeration.
std::span<const SurroundingsInfo> surroundings_kinds();

/// Of every kind.
std::span<const NumberRow<Surroundings>> surroundings_numbers();

/// Hue 0..1, value, scale and shift of the noise at its moment, as the shader takes them.
glm::dvec4 noise_now(const Surroundings& surroundings);

constexpr bool has_map(SurroundingsKind kind) {
    return kind == SurroundingsKind::sky || kind == SurroundingsKind::picture;
}

} // namespace preview
