// Which part of the finished picture is seen, and how large a pixel of it is. Plain: no GPU.
#pragma once

#include "lutlib/named.h"
#include "preview/gpu/size.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace preview {

/// How a picture that is seen larger than it is fills the pixels between.
struct Magnifier {
    std::string_view name;
    std::string_view help;
};
inline constexpr std::array<Magnifier, 2> magnifiers{{
    {"nearest", "squares: every pixel as it is"},
    {"smooth", "linear between the pixels' codes"},
}};
inline constexpr const Magnifier& magnifier_smooth = lutlib::row_named(magnifiers, "smooth");

struct Zoom {
    float scale = 0;          ///< output's pixels to one of the picture; 0: all is seen
    float x = 0.5F, y = 0.5F; ///< of its width and height: what the middle of the output shows
    const Magnifier* magnifier = &magnifiers.front();
    friend bool operator==(const Zoom&, const Zoom&) = default;
};
inline constexpr float least_zoom = 1.0F / 64, most_zoom = 64;

/// Scales that a person chooses by name.
struct ZoomStep {
    std::string_view label;
    float scale;
};
inline constexpr std::array<ZoomStep, 5> zoom_steps{
    {{"all", 0}, {"1:2", 0.5F}, {"1:1", 1}, {"2:1", 2}, {"8:1", 8}}};

/// How large a picture of that size is made so that it can be seen: smaller where it is seen
/// smaller (filtered by area), and never larger than it is.
Size made_size(const Zoom& zoom, Size own);

/// Where a picture lies in the output.
struct ZoomPlace {
    std::int32_t left = 0, top = 0; ///< of its upper left corner, in the output's pixels
    float scale = 1;                ///< the output's pixels to one of the picture as it was made
};
/// Of a picture of `own` size that was made that large, in an output of that size. It leaves no
/// room beside it where it is larger than the output, and stands in the middle where it is not.
ZoomPlace zoom_place(const Zoom& zoom, Size own, Size made, Size output);

/// The scale at which all of the picture is seen.
float fitting_scale(Size own, Size output);

struct OutputPoint {
    float x = 0, y = 0; ///< in the output's pixels
};
/// `factor` times as large, or all of it where that is all that is seen; what is at `fixed` stays
/// there.
Zoom zoomed_by(const Zoom& zoom, float factor, OutputPoint fixed, Size own, Size output);
/// Carried by so many pixels of the output.
Zoom panned_by(const Zoom& zoom, OutputPoint by, Size own, Size output);

} // namespace preview
