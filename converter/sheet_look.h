// The looks of a contact sheet, each on its way from a picture's codes to a display's.
#pragma once

#include "lutlib/engine/engine.h"
#include "lutlib/io/look.h"
#include "lutlib/recipe/placement.h"
#include "lutlib/transform.h"

#include <span>
#include <string>
#include <vector>

namespace converter {

/// What is the same for every look of a sheet.
struct SheetPlace {
    lutlib::Encoding picture;   ///< of the picture's codes
    lutlib::LookEncodings look; ///< as options name them, in place of what looks say
    bool converts = true;       ///< between encodings
    const lutlib::Adaptation& adaptation;
    const lutlib::Engine* engine = nullptr; ///< whose lookup is shown; null: the look itself
};

/// A file that a look may be in.
struct SheetSource {
    std::string path;
    bool in_folder = false; ///< nobody said that it is a look
};

struct SheetLook {
    std::string path;
    lutlib::Transform shown;     ///< from the picture's codes to sRGB
    lutlib::LookEncodings said;  ///< what the look is made for, as far as that is known
    lutlib::Placement placement; ///< what is converted around the look
    bool would_convert = false;  ///< unless it is asked not to
};

/// The picture's codes as sRGB.
lutlib::Transform shown_without_look(const SheetPlace& place);

struct SheetLooks {
    std::vector<SheetLook> looks;
    std::vector<std::string> left_out; ///< files of folders that are no looks
};

/// All of them, at most `at_once` at the same time, or an Error that names every look that cannot
/// be read; one where none is left. What a look does not say of its encodings is taken for sRGB. An
/// engine's are baked at its default size and depth. Says on standard error what was guessed and
/// lost in reading, look by look.
SheetLooks open_sheet_looks(std::span<const SheetSource> sources, const SheetPlace& place,
                            std::size_t at_once);

} // namespace converter
