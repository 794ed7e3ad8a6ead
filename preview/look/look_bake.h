// Makes a look ready for the lookup that shall read it: as its own table, or baked into the picture
// that an engine reads.
#pragma once

#include "lutlib/lut.h"
#include "preview/look/look_standing.h"
#include "preview/look/look_texels.h"

#include <memory>
#include <string>
#include <vector>

namespace preview {

struct LoadedLook {
    LookData data;
    /// Why it may as well be left out; empty when it does something.
    std::string skip_reason;
    std::string note; ///< how exactly it stands for its recipe; empty when not measured
    /// The look as a table, or what the picture that is read holds of it; null: no look.
    std::shared_ptr<const lutlib::Lut> table;
    /// What the reading of its file lost, guessed or did not act on, a line each.
    std::vector<std::string> told{};
    std::string encodings{}; ///< what of its encodings is known and follows, a sentence
    lutlib::Encoding shown = lutlib::srgb(); ///< what the codes are that are shown of it
};

/// Puts the look where it stands. One before the tone map is never left out, as it ends the light,
/// nor is one around which something is converted.
void set_standing(LoadedLook& look, const LookStanding& standing);

/// The lattice that a baked picture holds, of values as its engine's sampler sees them.
std::shared_ptr<const lutlib::Lut> table_of(const lutlib::Bake& baked);

/// What shows such a picture as it is.
LoadedLook no_look_of(const PictureCodes& picture);

/// A lattice whose channels do not mix is three curves, which a lookup that interpolates in floats
/// reads at a fraction of the price: each channel within 1e-6, everywhere. Any other look as it is.
lutlib::Lut without_lattice(lutlib::Lut look, const GpuLookup& lookup);

/// A lookup that reads a picture gets what `lutconv bake` makes of `exact`, which `table` stands
/// for. Throws lutlib::Error for a look that the lookup cannot hold.
LoadedLook look_for(std::shared_ptr<const lutlib::Lut> table, const lutlib::Transform& exact,
                    const GpuLookup& lookup);
/// The same of a look that is a table.
LoadedLook look_for(std::shared_ptr<const lutlib::Lut> table, const GpuLookup& lookup);
LoadedLook look_for(lutlib::Lut table, const GpuLookup& lookup);

/// The lookup of float tables that interpolates as the look asks for.
const GpuLookup& table_lookup(const lutlib::Lut& look);

/// "it changes less than half an output code" of 8 bits, or empty.
std::string skip_reason_of(const lutlib::Lut& look);

} // namespace preview
