// The transfer curves that other parts need by themselves, in double; all others are rows
// (transfer_curve.h).
#pragma once

namespace lutlib {

/// IEC 61966-2-1, odd: a negative code decodes to the negative light.
double srgb_decode(double code);
double srgb_encode(double linear);

/// SMPTE ST 2084. Light of 1 is 100 cd/m2, so a code of 1 decodes to 100. Codes and light outside
/// that range are clamped to it.
double pq_decode(double code);
double pq_encode(double linear);

/// SMPTE ST 2084 on absolute luminance in cd/m2, clamped to 0..10000.
double pq_from_nits(double nits);
double nits_from_pq(double code);

} // namespace lutlib
