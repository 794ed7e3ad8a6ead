// The inverse of a look, and what of it there is.
//
// A look is affine within each tetrahedron of its cube (the tetrahedral interpolation). For each
// wanted colour a grid over the look's outputs gives the cells that can produce it, and within each
// of their tetrahedra one Newton step is exact: so every input that gives the colour is found, and
// a fold shows as more than one. A colour that no input gives is out of the look's gamut: damped
// Newton steps (Levenberg 1944, Marquardt 1963) from the nearest nodes then find the input whose
// output lies nearest. Where many inputs give one colour, as where a look is clipped, the inverse
// takes the one nearest to the colour itself, so that a clipped white stays neutral. What cannot be
// inverted is filled so and counted, never silently.
#pragma once

#include "lutlib/lut.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/resample/invert_curve.h"
#include "lutlib/resample/resample.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lutlib {

/// Nodes of the inverse of one kind: how many, the box of wanted colours that holds them, and the
/// worst of them.
struct InverseRegion {
    std::size_t count = 0;
    Rgb low, high;
    Rgb worst;         ///< the wanted colour
    double extent = 0; ///< of the worst: see below
};

/// Of the look's inputs, even over its domain: shares 0..1 that add up to 1.
struct InputShares {
    double undoable = 0; ///< the output tells the input
    double flat = 0;     ///< inputs beside it give the same output, within six decimals
    double folded = 0;   ///< an input elsewhere does
};

struct Inversion {
    Lut lut;
    /// Of a look of a 1D table alone, whose inverse is one too; the regions are then empty.
    std::optional<std::array<CurveInversion::Channel, 3>> curve;
    std::size_t nodes = 0; ///< of the cube
    /// No input gives these colours. Extent: the distance to the nearest output, largest channel.
    InverseRegion out_of_gamut;
    /// More than one input does. Extent: the largest channel distance between those.
    InverseRegion folded;
    /// A whole edge, face or volume of inputs does. Extent: the largest channel distance of the one
    /// taken to the colour itself.
    InverseRegion flat;
    /// Nodes without an input of their own (out of gamut, or flat and not the colour itself) that
    /// give what is right for the colours between them and the next nodes.
    std::size_t extrapolated = 0;
    InputShares inputs;
    /// Of the inputs that were looked at for `inputs`, those that can be undone.
    std::vector<Rgb> undoable;
};

/// What the inverse holds where no one input gives the colour: none, or a range of them.
enum class Outside {
    nearest,     ///< the input whose output lies nearest; of a range, the nearest to the colour
    extrapolate, ///< the same, but where a cell also holds colours that have an input, what is
                 ///< right for those: the inverse goes on from there. A colour that the look leaves
                 ///< as it is stays itself.
    refuse,      ///< throws Error
};
struct OutsideInfo {
    Outside kind;
    std::string_view name;
    std::string_view help;
};
std::span<const OutsideInfo> outside_choices();

struct InvertOptions {
    /// Nodes a side of the inverse, or entries; default: the look's, or what a 1D table needs.
    std::optional<int> size{};
    /// Of the inverse; default: 0..1, widened to the look's outputs, or a 1D table's outputs.
    std::optional<Domain> domain{};
    Outside outside = Outside::extrapolate;
    /// none; look: see output_shaper(); or an encoding: its curve over the light of the inverse's
    /// domain before the cube, see encoding_shaper(). Puts the nodes where they matter. Of a look
    /// with a cube alone. Empty: none, or what invert_closely() chooses.
    std::string shaper{};
    int shaper_size = 4096;
    Encoding input = srgb(); ///< what the inverse's input codes are, for the shaper
};

/// The look's outputs, per channel.
Domain output_range(const Lut& lut);

/// A 1D table alone becomes a 1D table (invert_curve.h). Throws Error for a cube larger than 129
/// (resample it first), a 1D table before a cube that neither rises nor falls along its whole
/// length (an output of it has no single input), or a shaper that cannot be.
Inversion invert(const Lut& lut, const InvertOptions& options = {});

/// The size of the inverse where none is given.
int own_inverse_size(const Lut& lut);

/// invert() at several sizes, of a look that is not a 1D table alone: what is found out about the
/// look is found out once.
class Inverter {
  public:
    /// Takes no notice of options.size. Throws as invert() does.
    explicit Inverter(const Lut& lut, const InvertOptions& options = {});
    ~Inverter();

    Inversion of(int size) const;
    /// With this in place of options.shaper.
    Inversion of(int size, std::string_view shaper) const;

    /// Cells of the look to search for one colour, on average: above 1 where cells overlap.
    double work() const;

    /// Inversion::undoable.
    const std::vector<Rgb>& undoable() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace lutlib
