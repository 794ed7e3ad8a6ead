// Exposure by what the picture shows, as a camera's meter has it.
#pragma once

#include "lutlib/rgb.h"

#include <cstdint>
#include <optional>
#include <span>

namespace preview {

/// Light of the grey card that meters aim at, of which 1 is diffuse white.
inline constexpr double metered_grey = 0.18;

/// Stops that bring scene light's luma (BT.709) to metered_grey. Empty: it is dark.
std::optional<double> stops_to_grey(const lutlib::RgbD& light);

/// The same of a picture's mean luma in stops, of RGBA in halves, finite: Reinhard et al. 2002,
/// "Photographic tone reproduction for digital images", equation 1. What has no light, as bars about
/// a picture, does not count; what is darker than 2^-12 counts as that. Empty: all of it is.
std::optional<double> stops_to_grey(std::span<const std::uint16_t> rgba);

} // namespace preview
