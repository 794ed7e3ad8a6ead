// The operators' descriptors. A new operator is one file beside this one, its line here and its
// line in op.cpp's table.
#pragma once

#include "lutlib/ops/op.h"

namespace lutlib::op {

extern const Op exposure;
extern const Op white_balance;
extern const Op channel_mixer;
extern const Op highlights;
extern const Op lift_gamma_gain;
extern const Op offset;
extern const Op cdl;
extern const Op contrast;
extern const Op curves;
extern const Op saturation;
extern const Op saturation_perceptual;
extern const Op vibrance;
extern const Op split_toning;
extern const Op hue_vs_hue;
extern const Op hue_vs_sat;
extern const Op hue_vs_lum;
extern const Op lum_vs_sat;
extern const Op sat_vs_sat;
extern const Op sat_vs_lum;
extern const Op lum_vs_lum;
extern const Op hue_range;
extern const Op gamut_compression;

} // namespace lutlib::op
