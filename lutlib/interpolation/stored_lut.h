// A look as a program keeps it: an optional 1D table and a lattice in a storage of few bits.
#pragma once

#include "lutlib/interpolation/interpolation.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace lutlib {

enum class NodeFormat { codes8, codes10, codes16, halves, floats };

/// How a node's three values are kept.
struct Storage {
    NodeFormat format;
    std::string_view name;
    std::string_view label;
    std::size_t bytes;  ///< of a node
    int bits;           ///< of codes of 0..1; 0 for floating point
    std::size_t stride; ///< bytes from a node to the next as a program keeps them
};

/// 8 bits, 10 bits (three in 32), 16 bits, half, float.
std::span<const Storage> storages();

/// How nodes are weighed, and in how many bits the fractions between them are held.
struct Lookup {
    std::string_view name;
    std::string_view label;
    Interpolation weights;
    int fraction_bits; ///< 0: full float
};

/// nearest, trilinear, tetrahedral, hardware (trilinear with 8 fraction bits, as texture units do).
std::span<const Lookup> lookups();
/// The one that weighs nodes so, with full fractions.
const Lookup& lookup_of(Interpolation how);

class StoredLut {
  public:
    /// In floats, as it is.
    explicit StoredLut(const Lut& lut);
    /// `nodes` lie over `lut.cube`'s domain, red fastest; lut.cube's own are not read. Codes are
    /// rounded to nearest and held to 0..1, half floats to +-65504.
    StoredLut(const Lut& lut, const std::vector<RgbD>& nodes, const Storage& storage);

    /// Every colour of `in` into `out`, of the same length, on the calling thread (apply.h).
    /// Outside the domain as evaluate().
    void apply(std::span<const Rgb> in, std::span<Rgb> out, const Lookup& lookup) const;

    const Storage& storage() const { return *storage_; }
    const std::optional<Lut1D>& shaper() const { return shaper_; }
    /// Nodes a side; 0 when there is no lattice.
    int size() const { return size_; }
    const Domain& cube_domain() const { return cube_domain_; }
    /// The nodes, red fastest, storage().stride apart; 16 bytes from each may be read. Floats are
    /// aligned to 16 bytes.
    const std::uint8_t* nodes() const { return data_.data(); }

    /// Of the lattice and the 1D table, which is kept in floats.
    std::size_t bytes() const;

  private:
    const Storage* storage_;
    std::optional<Lut1D> shaper_;
    int size_ = 0;
    Domain cube_domain_;
    std::vector<std::uint8_t> data_;
};

} // namespace lutlib
