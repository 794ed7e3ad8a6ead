// A look as the picture kernels read it, and the kernels' entry.
#pragma once

#include "lutlib/interpolation/picture_view.h"
#include "lutlib/lut.h"

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace lutlib {

/// 64 bytes, a line of the caches.
struct alignas(64) CacheLine {
    std::array<std::byte, 64> bytes{};
};

/// Every table has zeros behind its last node: what a cell on the upper faces reads and weighs by
/// 0.
struct GradeTables {
    /// Nodes red, green, blue, 0 in floats: 16 bytes.
    static constexpr std::size_t node_bytes = 16;
    /// For tetrahedra, in floats, 128 bytes: node p and the one across its cell; then p and its
    /// neighbour along red, p and that along green, p and that along blue.
    static constexpr std::size_t pairs_bytes = 128;
    /// The same four pairs in 16 bits with a sign, 64 bytes: red of the first node and of the
    /// second, then green, blue and 0.
    static constexpr std::size_t cell_bytes = 64;
    /// Larger lattices would not stay in the caches as pairs or cells.
    static constexpr int largest_of_cells = 65;
    /// What the weights of a cell's nodes, integers, come to.
    static constexpr int whole = 255;
    /// A sum of 16-bit nodes so weighed, and cell_bias(), is an 8-bit code times 2^16 where all
    /// nodes lie within 0..1, else times 2^15; and a half of that, to round.
    static constexpr int cell_bits_within = 16, cell_bits_beyond = 15;

    GradeTables(const Lut& lut, Interpolation kind);

    std::optional<Lut1D> shaper;
    int size = 0; ///< nodes a side; 0: no lattice
    Domain domain;
    Interpolation how;
    float least = 0, largest = 0; ///< of the nodes' values
    bool is_plain = false;        ///< the lattice spans 0..1 and nothing comes before it

    const std::byte* nodes() const { return nodes_.data()->bytes.data(); }
    /// Null where there are none.
    const std::byte* pairs() const { return pairs_.empty() ? nullptr : pairs_[0].bytes.data(); }

    /// Made when first asked for; null where 16 bits are too few for 8-bit results, or the look is
    /// not plain.
    const std::byte* cells() const;
    std::int32_t cell_bias() const { return cell_bias_; }
    bool is_within() const { return cell_bits_ == cell_bits_within; }

  private:
    void make_pairs(const Lut3D& cube);
    void choose_cells();
    void make_cells() const;

    std::vector<CacheLine> nodes_, pairs_;
    mutable std::once_flag cells_once_;
    mutable std::vector<CacheLine> cells_;
    int cell_bits_ = 0; ///< 0: there are no cells
    double cell_base_ = 0;
    std::int32_t cell_bias_ = 0;
};

/// What the lattice makes of a colour behind the 1D table, in double.
RgbD weighed_nodes(const GradeTables& tables, RgbD color);

/// Whether kernels of this processor read and write the element.
bool has_kernel(Element element);

/// Pixels of four samples, in a row without gaps, into such; `out` is `in` or does not overlap it.
/// Needs a lattice, or a 1D table and floats. `past_caches`: what is written will not be read soon.
void grade_pixels(const GradeTables& tables, Element element, const std::byte* in, std::byte* out,
                  std::size_t pixels, bool past_caches);

} // namespace lutlib
