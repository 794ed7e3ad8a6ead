// The rows of curves and gamuts. A new one is a row in its maker's file beside this one, its line
// here and its line in encoding.cpp's table.
#pragma once

#include "lutlib/color/transfer_curve.h"

namespace lutlib::gamut {

extern const Gamut rec709, rec2020, p3_d65, p3_dci, display_p3, adobe_rgb;
extern const Gamut ap0, ap1;
extern const Gamut arri_wide_gamut3, arri_wide_gamut4;
extern const Gamut sgamut3, sgamut3_cine;
extern const Gamut vgamut;
extern const Gamut cinema_gamut;
extern const Gamut red_wide_gamut;
extern const Gamut dgamut;
extern const Gamut blackmagic_wide_gamut, davinci_wide_gamut;
extern const Gamut protune_native;

} // namespace lutlib::gamut

namespace lutlib::curve {

extern const TransferCurve srgb, rec709, gamma22, gamma24, gamma26, linear;
extern const TransferCurve pq, hlg;
extern const TransferCurve acescc, acescct;
extern const TransferCurve cineon;
extern const TransferCurve logc3, logc3_ei160, logc3_ei200, logc3_ei250, logc3_ei320, logc3_ei400,
    logc3_ei500, logc3_ei640, logc3_ei1000, logc3_ei1280, logc3_ei1600, logc4;
extern const TransferCurve slog2, slog3;
extern const TransferCurve vlog;
extern const TransferCurve clog, clog2, clog3;
extern const TransferCurve log3g10;
extern const TransferCurve flog, flog2;
extern const TransferCurve nlog;
extern const TransferCurve dlog;
extern const TransferCurve blackmagic_film5, davinci_intermediate;
extern const TransferCurve applelog;
extern const TransferCurve protune;
extern const TransferCurve o3de_log2;

} // namespace lutlib::curve
