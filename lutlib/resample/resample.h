// A look on another lattice: another size, another domain, another 1D table before the cube.
#pragma once

#include "lutlib/color/encoding.h"
#include "lutlib/lut.h"
#include "lutlib/transform.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lutlib {

/// One way of reading a look between its nodes.
struct ResamplingMethod {
    std::string_view name;
    std::string_view help;
    /// The whole look, its 1D table linearly. The look must outlive the transform.
    Transform (*transform_of)(const Lut& lut);
};

/// trilinear, tetrahedral, tricubic.
std::span<const ResamplingMethod> resampling_methods();
const ResamplingMethod* resampling_method_named(std::string_view name);
/// No row of the table: each look as it asks to be read.
const ResamplingMethod& usual_resampling();

/// Nodes a side where nothing says how many.
inline constexpr int usual_cube_size = 33;

/// The result's lattice. Unset members: as the look has them.
struct Sampling {
    /// Nodes a side, or entries of a 1D table alone. Default: the cube's, 33 for a look without
    /// one; the table's.
    std::optional<int> size;
    std::optional<Domain> domain; ///< default: the look's
    std::string shaper;           ///< none, base, or an encoding; see below
    int shaper_size = 4096;
    Encoding input = srgb(); ///< what the look's input codes are, for an encoding's shaper
};

/// What Sampling::shaper may be.
std::vector<std::string_view> shaper_names();

/// The look at the nodes of the new lattice. A look of a 1D table alone stays one while `shaper` is
/// empty. `shaper`:
///   ""           as the look has it, unless a domain is given, which means none
///   "none"       a cube alone
///   "base"       the look's own 1D table, untouched, and its cube at the new size over its domain
///   an encoding  that encoding's curve over the light of the domain, then a cube over 0..1
/// Throws Error for a table or a size that cannot be.
Lut resample(const Lut& lut, const Sampling& sampling, const ResamplingMethod& method);

/// Any transform sampled so, `like` lending whatever `sampling` leaves open and its 1D table for
/// "base"; `after_table` is then the transform of what that table gives.
Lut sample_like(const Lut& like, const Sampling& sampling, const Transform& whole,
                const Transform& after_table);

} // namespace lutlib
