// A look as a program keeps it: an optional 1D table and a lattice in a storage of few bits, read
// by a scalar loop that does what that storage and that lookup cost.
#pragma once

#include "lutlib/interpolation.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace lutlib {

/// How a node's three values are kept.
struct Storage {
    std::string_view name;
    std::string_view label;
    std::size_t bytes; ///< of a node
    int maximum;       ///< code of 1; 0 for floating point
    bool half = false;
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

class StoredLut {
  public:
    /// `nodes` lie over `lut.cube`'s domain, red fastest; lut.cube's own are not read. Codes are
    /// rounded to nearest and held to 0..1, half floats to +-65504.
    StoredLut(const Lut& lut, const std::vector<RgbD>& nodes, const Storage& storage);

    /// Every colour of `in` into `out`, of the same length, on the calling thread; allocates
    /// nothing. Outside the domain as evaluate().
    void apply(std::span<const Rgb> in, std::span<Rgb> out, const Lookup& lookup) const;

    /// Of the lattice and the 1D table, which is kept in floats.
    std::size_t bytes() const;

  private:
    template <class Fetch>
    void apply_storage(std::span<const Rgb> in, std::span<Rgb> out, const Lookup& lookup) const;
    template <class Fetch, int lookup>
    void apply_lookup(std::span<const Rgb> in, std::span<Rgb> out) const;
    template <class Fetch, int lookup>
    Rgb read(Rgb in) const;

    const Storage* storage_;
    std::optional<Lut1D> shaper_;
    int size_;
    Rgb low_, scale_; ///< of the lattice's domain, in nodes
    std::vector<std::uint8_t> data_;
};

} // namespace lutlib
