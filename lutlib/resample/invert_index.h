// Which inputs of a cube give an output: a grid over the cube's outputs, for invert.
#pragma once

#include "lutlib/lut.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace lutlib {

struct Nearest {
    RgbD input;
    double distance = 0; ///< of its output to the wanted colour, largest channel
};

/// The inputs whose tetrahedral interpolation is one colour.
struct Preimages {
    std::vector<RgbD> points; ///< one for each tetrahedron that holds one
    /// Of whole edges, faces and volumes of inputs that all give it, as where a look is clipped,
    /// the input nearest to the colour asked.
    std::optional<RgbD> flat;
};

class OutputIndex {
  public:
    /// The cube must be valid and outlive the index.
    explicit OutputIndex(const Lut3D& cube);

    /// Of `wanted`; of flat tetrahedra (whose volume of outputs is rounding) the input nearest to
    /// `near`, each channel in widths of the cube's domain.
    Preimages preimages(RgbD wanted, RgbD near) const;

    /// How many cells preimages() looks at for the image of an input, on average over the inputs.
    double cells_of_bucket() const;

    /// Whether the tetrahedron that holds this input of the cube is flat.
    bool is_flat(RgbD input) const;

    /// The input whose output lies nearest that damped Newton steps find from the nearest nodes.
    Nearest nearest(RgbD wanted) const;

  private:
    using Bucket = std::array<int, 3>;
    Bucket bucket_of(RgbD output) const;
    std::size_t bucket_index(const Bucket& b) const;
    void divide(RgbD high, int buckets);
    bool may_give(RgbD wanted, double tolerance) const;
    template <class F>
    void each_cell(F visit) const;
    std::uint64_t cell_entries() const;
    void look_at_cells();
    RgbD place(const std::array<double, 3>& lattice) const;
    std::array<double, 3> lattice_of(RgbD input) const;
    RgbD share_of(RgbD input) const;
    Nearest descend(RgbD wanted, std::array<double, 3> start) const;

    const Lut3D& cube_;
    RgbD low_, scale_; // output to bucket
    double span_ = 0;  // of the outputs, widest channel
    double rounding_ = 0;
    int buckets_ = 1; // a side
    // Cells (by their lower node's index) whose outputs touch a bucket, and nodes within one. The
    // starts count entries, which limits.h caps below 2^32.
    std::vector<std::uint32_t> cell_start_, cells_;
    std::vector<std::uint32_t> node_start_, nodes_;
    // Of each cell, by its lower node's index: a bit for each of its tetrahedra that is flat, and
    // the box of its outputs.
    std::vector<std::uint8_t> flat_;
    struct Box {
        Rgb low, high;
    };
    std::vector<Box> outputs_;
};

} // namespace lutlib
