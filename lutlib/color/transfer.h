// Transfer curves: code values to linear light and back, in double.
//
// Every curve is defined for every finite input. The display curves are odd functions (a negative
// code decodes to the negative light), so that a wide-gamut colour survives the round trip; the
// camera and HDR curves stop at the largest light that they define.
#pragma once

namespace lutlib {

/// IEC 61966-2-1, odd.
double srgb_decode(double code);
double srgb_encode(double linear);

/// ITU-R BT.1886 with a black level of zero: a pure power of 2.4, odd.
double gamma24_decode(double code);
double gamma24_encode(double linear);

/// ARRI, "ALEXA Log C Curve, Usage in VFX" (2017), LogC3 scene exposure curve at EI 800; 0.18 is
/// mid grey. Below its toe the curve goes on as the straight line that it is there; light is
/// limited to 65504.
double logc3_decode(double code);
double logc3_encode(double linear);

/// S-2016-001, ACEScct; light is limited to 65504, the largest half float.
double acescct_decode(double code);
double acescct_encode(double linear);

/// SMPTE ST 2084. Light of 1 is 100 cd/m2, so a code of 1 decodes to 100. Codes and light outside
/// that range are clamped to it.
double pq_decode(double code);
double pq_encode(double linear);

/// SMPTE ST 2084 on absolute luminance in cd/m2, clamped to 0..10000.
double pq_from_nits(double nits);
double nits_from_pq(double code);

} // namespace lutlib
