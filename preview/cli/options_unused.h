// Options of a command line that change nothing in what it asks for, and what of it a file lacks.
#pragma once

#include "preview/cli/option_needs.h"

#include <string>
#include <vector>

namespace preview {

/// A sentence for each that was given, as far as the command line alone tells.
std::vector<std::string> unused_options(const Options& options);

/// A sentence for each that was given and changes nothing of this input, without a window.
/// `settings` are those that settings_of() makes of `options`.
std::vector<std::string> unused_options(const Options& options, const KnownInput& input,
                                        const FrameSettings& settings);

/// Which option such a sentence is about, as "--split".
std::string unused_option(const std::string& line);

/// What a person has asked for and a file of the light before the tone map has not, in a sentence
/// with the remedy; empty: nothing.
std::string not_in_light(const Options& options, const FrameSettings& settings);

/// An effect or another part of the frame that a person has asked for, and by what.
struct AskedPart {
    std::string name;   ///< as the frame calls it
    std::string option; ///< as "--effect vignette"
};
/// Those that are not switched off by another option.
std::vector<AskedPart> asked_parts(const Options& options);

} // namespace preview
