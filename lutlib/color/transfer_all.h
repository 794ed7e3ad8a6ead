// The transfer curves of transfer.h on many colours at once, each within 1e-12 of it.
#pragma once

#include "lutlib/rgb.h"

#include <span>

namespace lutlib {

void srgb_decode_all(std::span<RgbD> colours);
void srgb_encode_all(std::span<RgbD> colours);
void gamma24_decode_all(std::span<RgbD> colours);
void gamma24_encode_all(std::span<RgbD> colours);
void logc3_decode_all(std::span<RgbD> colours);
void logc3_encode_all(std::span<RgbD> colours);
void acescct_decode_all(std::span<RgbD> colours);
void acescct_encode_all(std::span<RgbD> colours);
void pq_decode_all(std::span<RgbD> colours);
void pq_encode_all(std::span<RgbD> colours);

} // namespace lutlib
