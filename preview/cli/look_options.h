// What the options say of the two sides' looks.
#pragma once

#include "preview/cli/options.h"
#include "preview/frame/shown.h"
#include "preview/look/look_file.h"
#include "preview/look/still.h"

#include <array>
#include <memory>

namespace preview {

/// The lookup that `name` names; null for an empty name. Throws lutlib::UsageError.
const GpuLookup* lookup_of(const std::string& name);

/// What the looks of both sides get of a picture that has scene light or not. Throws
/// lutlib::UsageError for an encoding that is not known.
PictureCodes picture_codes(const Options& options, bool has_light);

/// How each side's look is used. Throws lutlib::UsageError for names that no table has, and for an
/// engine of a side that has no look while the other has one.
LookUse use_a(const Options& options, bool has_light);
LookUse use_b(const Options& options, bool has_light);

/// The scene or picture that the options name, with the picture of its surroundings. Throws as
/// load_shown() and load_surroundings() do.
Shown shown_of(const Options& options);

/// Of each side; null: none. Throws lutlib::Error, and UsageError for a side that has a look too.
std::array<std::shared_ptr<const Still>, 2> stills_of(const Options& options);

} // namespace preview
