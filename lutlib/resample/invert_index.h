// Which inputs of a cube give an output: a grid over the cube's outputs, for invert.
#pragma once

#include "lutlib/lut.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lutlib {

struct Nearest {
    RgbD input;
    double distance = 0; ///< of its output to the wanted colour, largest channel
};

class OutputIndex {
  public:
    /// The cube must be valid and outlive the index.
    explicit OutputIndex(const Lut3D& cube);

    /// Every input whose tetrahedral interpolation is `wanted`, one for each tetrahedron that holds
    /// it. Flat tetrahedra (a clipped corner) are left out; nearest() finds a point in them.
    void preimages(RgbD wanted, std::vector<RgbD>& found) const;

    /// The input whose output lies nearest that damped Newton steps find from the nearest nodes.
    Nearest nearest(RgbD wanted) const;

  private:
    using Bucket = std::array<int, 3>;
    Bucket bucket_of(RgbD output) const;
    std::size_t bucket_index(const Bucket& b) const;
    void divide(RgbD high, int buckets);
    template <class F>
    void each_cell(F visit) const;
    std::uint64_t cell_entries() const;
    RgbD place(const std::array<double, 3>& lattice) const;
    Nearest descend(RgbD wanted, std::array<double, 3> start) const;

    const Lut3D& cube_;
    RgbD low_, scale_; // output to bucket
    int buckets_ = 1;  // a side
    // Cells (by their lower node's index) whose outputs touch a bucket, and nodes within one. The
    // starts count entries, which limits.h caps below 2^32.
    std::vector<std::uint32_t> cell_start_, cells_;
    std::vector<std::uint32_t> node_start_, nodes_;
};

} // namespace lutlib
