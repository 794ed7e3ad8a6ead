// ASC CDL files and the look's operator "cdl". Throws lutlib::Error.
#pragma once

#include "lutlib/recipe/color_correction.h"
#include "preview/editor/look_export.h"
#include "preview/editor/model.h"

#include <optional>
#include <string>

namespace preview::editor {

/// The place of the look's first CDL.
std::optional<std::size_t> cdl_of(const lutlib::Recipe& recipe);

/// Its numbers go into the look's first CDL, whose clamp and opacity stay, or into a new one at the
/// look's end. The answer is what of them that does not hold, and what the standard would clamp, in
/// lines.
std::string put_correction(State& state, const lutlib::ColorCorrection& correction);

/// The look's first CDL under that id, as the file at `path` then has it; see
/// lutlib::io::correction_bytes().
PreparedExport prepare_correction(const State& state, const std::string& id,
                                  const std::string& path);

} // namespace preview::editor
