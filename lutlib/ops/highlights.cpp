// Highlight compression: a shoulder that brings light up to `white` down to 1 and leaves light
// below `start` alone.
//
// With t = (x - start) / (1 - start) and T the same of white, t becomes t (1 + t / T^2) / (1 + t)
// (E. Reinhard et al., "Photographic Tone Reproduction for Digital Images", 2002, equation 4): it
// leaves the start with slope 1 and maps T to 1.
#include "lutlib/ops/all.h"

#include <algorithm>

namespace lutlib::op {
namespace {

constexpr Parameter highlights_parameters[] = {
    {.name = "white",
     .flag = "highlights-white",
     .label = "Brought to white",
     .unit = "linear light",
     .min = 1,
     .max = 64,
     .fallback = 1},
    {.name = "start",
     .flag = "highlights-start",
     .label = "Start of the shoulder",
     .unit = "linear light",
     .min = 0,
     .max = 0.95,
     .fallback = 0.5},
    {.name = "bleach",
     .flag = "highlights-bleach",
     .label = "Bleach",
     .unit = "share",
     .min = 0,
     .max = 1,
     .fallback = 0.5},
};

Transform compile_highlights(const Values& values, const OpContext&) {
    const double white = std::get<double>(values[0]), start = std::get<double>(values[1]),
                 bleach = std::get<double>(values[2]);
    if (white == 1) {
        return {};
    }
    const double room = 1 - start, top = (white - start) / room, tail = 1 / (top * top);
    const auto shoulder = [start, room, tail](double x) {
        const double t = (x - start) / room;
        return t > 0 ? start + room * (t * (1 + t * tail) / (1 + t)) : x;
    };
    return Transform::each([shoulder, bleach](RgbD c) {
        const double peak = std::max({c.r, c.g, c.b});
        const double scale = peak > 0 ? shoulder(peak) / peak : 1;
        const RgbD each{shoulder(c.r), shoulder(c.g), shoulder(c.b)};
        return c * (scale * (1 - bleach)) + each * bleach;
    });
}

bool is_highlights_per_channel(const Values& values) {
    return std::get<double>(values[2]) == 1; // bleach
}

} // namespace

const Op highlights{
    .name = "highlights",
    .label = "Highlight compression",
    .help = "Rolls bright light off so that `white` arrives at 1; bleach 0 keeps hues (scales by "
            "the largest channel), 1 compresses each channel, which pales bright colours",
    .reference = "Reinhard et al. 2002, equation 4, above a knee",
    .space = Space::linear,
    .parameters = highlights_parameters,
    .monotone_on_neutrals = true,
    .per_channel = is_highlights_per_channel,
    .compile = compile_highlights};

} // namespace lutlib::op
