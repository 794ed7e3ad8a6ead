// Reference colours as light.
#pragma once

#include "lutlib/color/swatches.h"

#include <cstdint>
#include <glm/vec3.hpp>

namespace preview {

using lutlib::color_checker;
using lutlib::LabSwatch;
using lutlib::measured_skins;
using lutlib::skin_tones;
using lutlib::Swatch;

/// Linear values of a display-encoded colour (IEC 61966-2-1).
glm::vec3 linear_of(const Swatch& swatch);

/// Linear values of a colour under D65; 0 where it lies outside sRGB.
glm::vec3 linear_of(const LabSwatch& swatch);
glm::vec3 linear_of_lab(glm::vec3 lab);

/// Linear light of a display code in 0..1 (IEC 61966-2-1).
float linear_of_code(float code);

/// Linear values of a colour given as 0xRRGGBB code values.
glm::vec3 linear_of(std::uint32_t srgb);

} // namespace preview
