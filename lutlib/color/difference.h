// Perceptual distances between two colours.
//
// A colour with a channel that is not finite is infinitely far from every colour, itself included:
// the functions return +Inf, so that a broken transform cannot hide in an average.
#pragma once

#include "lutlib/rgb.h"

namespace lutlib {

/// CIE 1976 L*a*b*: L 0..100 for colours within the gamut.
struct Lab {
    double L = 0, a = 0, b = 0;
};

/// L*a*b* under D65 of linear Rec.709 light whose white is 1. The white is the primaries' own, so
/// neutrals have a = b = 0. Negative tristimulus values go on along the linear part of the curve.
Lab lab_from_linear(RgbD linear_rec709);
Lab lab_from_srgb(RgbD srgb_encoded);

/// CIEDE2000, kL = kC = kH = 1 (Sharma, Wu, Dalal: "The CIEDE2000 Color-Difference Formula", Color
/// Research and Application 30(1), 2005). About 1 is just noticeable.
double delta_e_2000(Lab a, Lab b);
double delta_e_2000(RgbD srgb_encoded_a, RgbD srgb_encoded_b);

/// ITU-R BT.2124 of absolute light in cd/m2 on Rec.2020 primaries. 1 is just noticeable.
double delta_e_itp_nits(RgbD rec2020_nits_a, RgbD rec2020_nits_b);
/// The same of sRGB-encoded colours on a display whose white has `white_nits` cd/m2.
double delta_e_itp(RgbD srgb_encoded_a, RgbD srgb_encoded_b, double white_nits = 100);

} // namespace lutlib
