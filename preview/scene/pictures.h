// Pictures made by formulas, for surfaces of the built-in scenes: no files, the same on every
// machine. Repeated side by side they show no seam, unless it says so.
#pragma once

#include "preview/scene/texture.h"

#include <glm/vec2.hpp>

namespace preview {

/// Rings of light from 0 to 1, linear, that lie the closer the farther out: the phase is
/// pi n r^2 / 2, r being 1 at the middle of a side. Not seamless.
Picture zone_plate(std::uint32_t side, float n);

// Made at the first call and kept.

/// Four boards along u with their grain, and their roughness in green.
const Picture& boards();
const Picture& board_surface();
/// Threads over and under each other, `weave_threads` along each side: shades about white, and
/// normals.
inline constexpr int weave_threads = 32;
const Picture& weave_shades();
const Picture& weave_normals();
/// Scratches along u.
const Picture& brushed_normals();
/// Small dents, as in the skin of an orange.
const Picture& dented_normals();
/// Clouds about white.
const Picture& plaster();

/// A garden out of focus under a bright sky, as shares of white. Not seamless.
const Picture& garden();

/// Smooth noise in 0..1 that repeats after so many cells; the same for the same arguments.
float value_noise(glm::vec2 at, glm::ivec2 period, std::uint32_t seed);
/// Octaves of value_noise, each of twice the frequency and half the height; in 0..1.
float layered_noise(glm::vec2 at, glm::ivec2 period, int octaves, std::uint32_t seed);

} // namespace preview
