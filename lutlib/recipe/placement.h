// A look among code values that it is not made for: what has to be converted before and after it.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/lut.h"
#include "lutlib/transform.h"

#include <optional>
#include <string>
#include <string_view>

namespace lutlib {

/// A change of encoding: decoded to light, through both whites' adaptation, encoded again.
struct Conversion {
    Encoding from, to;

    friend bool operator==(const Conversion&, const Conversion&) = default;
};

/// Exact, and held within the range of a float.
Transform conversion(const Conversion& conversion, const Adaptation& adaptation = bradford);

/// Conversions around a look, each only where both encodings are known and differ.
struct Placement {
    std::optional<Conversion> before, after;
    const Adaptation* adaptation = &bradford;

    bool converts() const { return before || after; }
    /// The look with its conversions.
    Transform around(const Transform& look) const;
    /// The inputs that the look gets where it is given codes of 0..1: bounds, per channel.
    Domain fed() const;
    /// "srgb is converted to logc3 before the look, rec709 to srgb after it"; empty where nothing
    /// is.
    std::string text() const;
};

/// What a look is made for, and where it stands.
struct LookPlace {
    LookEncodings look;
    std::optional<Encoding> given;  ///< what it gets; unset: not known, or whatever it is made for
    std::optional<Encoding> wanted; ///< what its results are read as
    bool convert = true;            ///< false: the caller leaves the codes as they are
    const Adaptation* adaptation = &bradford; ///< between different whites

    /// What would make the two meet.
    Placement needed() const;
    /// The same, or nothing where the caller converts nothing.
    Placement applied() const;
    /// What the look with its conversions takes and gives, as far as that is known.
    LookEncodings shown() const;
    /// Whether the look gets or gives codes of another encoding.
    bool is_wrong() const;
    /// Whether a look's encoding is unknown where there is one that it should be compared with.
    bool is_unknown() const;
};

/// What follows for the codes, a sentence without its full stop that calls the place `where`, such
/// as "unity". Empty where the place takes any encoding and the look's are not known.
std::string sentence_of(const LookPlace& place, std::string_view where);

} // namespace lutlib
