// What preview_bench draws: no files are needed.
#pragma once

#include "lutlib/lut.h"
#include "preview/gpu/size.h"

#include <cstdint>
#include <vector>

namespace preview {

/// A look that mixes channels and bends tones: saturation and an S-curve.
lutlib::Lut sample_look(int size);

/// A picture with the statistics of a photograph: smooth, with edges, fine noise and a few lights.
/// RGBA, rows from the top; lights up to `brightest`.
std::vector<float> picture_texels(Size size, float brightest);

/// In codes of 8 bits.
std::vector<std::uint8_t> codes_of(const std::vector<float>& texels);

/// How far away each pixel is: nothing in a quarter of the picture, discs from 0.5 to 8 metres
/// elsewhere; as 1 - near_plane / z, 1 where there is nothing.
inline constexpr float depths_near_plane = 0.1F;
std::vector<float> picture_depths(Size size);

} // namespace preview
