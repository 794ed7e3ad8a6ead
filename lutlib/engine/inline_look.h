// Looks that are small enough to stand in a shader's code: a lattice of packed nodes, which may
// have a shaper before it, or curves and a matrix between them. What is evaluated here is what the
// code computes.
#pragma once

#include "lutlib/color/matrix.h"
#include "lutlib/engine/shader_code.h"
#include "lutlib/lut.h"
#include "lutlib/transform.h"

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace lutlib {

/// Nodes over a domain, red fastest, read tetrahedrally. A node is red, green and blue in 10 bits
/// each from the lowest: the same for all, so that greys stay grey.
struct InlineLattice {
    Domain domain;
    int size = 0;
    Rgb low, step; ///< code c of a channel stands for low + c * step
    std::vector<std::uint32_t> nodes;
};
inline constexpr unsigned inline_bits = 10;

/// A curve through entries, constant beyond the ends.
struct InlineCurve {
    float low = 0, high = 1; ///< inputs of the first and the last entry
    std::vector<float> entries;
    /// Entries stand evenly, and what is between them is linear, over the square root of an input's
    /// share of the way from low to high, which gives darks of light their due; else over the
    /// share.
    bool by_root = false;
};

/// A curve for each channel, a matrix, and a curve for each of its results. `mixes` is false where
/// the channels do not mix: then there are the curves `after` alone.
struct InlineCurves {
    Domain domain;
    bool mixes = false;
    std::array<InlineCurve, 3> before;
    std::array<Rgb, 3> matrix{}; ///< rows
    std::array<InlineCurve, 3> after;
};

/// A curve for each channel, and a lattice that reads their results, held to its own domain.
struct InlineShaped {
    Domain domain; ///< of the curves
    std::array<InlineCurve, 3> shaper;
    InlineLattice lattice;
};

using InlineLook = std::variant<InlineLattice, InlineCurves, InlineShaped>;

/// Nodes of a look over a domain, each in the nearest code.
InlineLattice inline_lattice(const Transform& look, const Domain& domain, int size);
/// Of a table that has a shaper and a cube: the shaper in its own entries, or in `most_entries`
/// where they are fewer; the cube, as `how` reads it, in `size` nodes a side.
InlineShaped inline_shaped(const Lut& table, Interpolation how, int size, int most_entries);

/// In double, with the constants as they stand in the code. Inputs are held to the domain, NaN
/// reads as its minimum.
Transform transform_of(const InlineLook& look);
/// "9 nodes per axis", "curves of 33 entries and a matrix".
std::string text_of(const InlineLook& look);
/// How many constants it takes.
std::size_t numbers_of(const InlineLook& look);

/// The text of a file with the function lut_lookup, which computes transform_of() in floats and
/// reads no picture. `heading` is said in a comment before it.
std::string inline_code(const InlineLook& look, const ShaderLanguage& language,
                        const std::string& heading);

} // namespace lutlib
