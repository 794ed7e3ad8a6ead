// Whether a picture is the bake of a look, and if not, what went wrong.
#pragma once

#include "converter/verify_result.h"

#include <optional>
#include <string>

namespace converter {

class ConfigOptions;

/// What a picture is held against.
struct Question {
    std::string picture, against; ///< as they were named
    /// How the look was read between its nodes; unset: as the picture's text says.
    std::optional<lutlib::Interpolation> interpolation;
    lutlib::LookEncodings look; ///< in place of what the look says
    bool convert = true;        ///< LookPlace::convert
    const lutlib::Adaptation* adaptation = &lutlib::bradford;
    const ConfigOptions* config = nullptr; ///< where one was given, it says what is converted
    bool quiet = false;                    ///< says nothing on standard error
    std::size_t samples = lutlib::SampleLimits{}.even;
    double reference_white = lutlib::reference_white_nits;
};

/// Opens the look, has OpenColorIO evaluate it, and compares. Throws Error.
Verdict judge(const Subject& subject, const Question& question);

} // namespace converter
