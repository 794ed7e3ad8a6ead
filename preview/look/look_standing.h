// Where a look stands, before the tone map or behind it, and what is converted for it there.
#pragma once

#include "lutlib/named.h"
#include "lutlib/recipe/placement.h"
#include "preview/look/gpu_lookups.h"
#include "preview/look/look_conversion.h"

#include <array>
#include <optional>
#include <string>

namespace preview {

/// What a person may say of that.
struct LookAt {
    std::string_view name;
    std::string_view help;
};
inline constexpr std::array<LookAt, 3> look_ats{{
    {"auto",
     "where the look's or the engine's input encoding says: log and linear light before the "
     "tone map, a display's codes behind it"},
    {"before", "before the tone map: scene light, encoded as the look takes it"},
    {"after", "behind the tone map: the display's codes"},
}};
inline constexpr const LookAt& look_at_auto = lutlib::row_named(look_ats, "auto");
inline constexpr const LookAt& look_at_before = lutlib::row_named(look_ats, "before");
inline constexpr const LookAt& look_at_after = lutlib::row_named(look_ats, "after");

/// The picture that looks are laid over; what they give is shown as sRGB.
struct PictureCodes {
    lutlib::Encoding encoding = lutlib::srgb(); ///< of the codes behind the tone map
    bool convert = true;                        ///< for looks that are made for other codes
    bool has_light = false;                     ///< there is a tone map, and scene light before it
    const LookAt* at = &look_at_auto;
    friend bool operator==(const PictureCodes&, const PictureCodes&) = default;
};

struct LookStanding {
    /// What the shader converts around its table, and whether it stands before the tone map. Behind
    /// it, an engine's look has none: the engine gives its picture the codes of the screen.
    std::optional<LookConversion> conversion;
    /// Among what codes the look's table stands: what must be converted in the table itself.
    lutlib::LookPlace place;
    /// What the codes are that are shown of it.
    lutlib::Encoding shown = lutlib::srgb();
    /// What follows, a sentence without its full stop.
    std::string sentence;
    /// The look is not fed what it is made for, or that is not known, or something is converted.
    bool is_told = false;

    bool is_before() const { return conversion && conversion->is_before(); }
};

/// `lookup` may be null. Throws lutlib::UsageError for an engine's lookup where it cannot stand.
LookStanding standing_of(const lutlib::LookEncodings& look, const GpuLookup* lookup,
                         const PictureCodes& picture);

} // namespace preview
