// What each engine expects of a LUT picture (its contract) and how its shader reads one (its
// lookup), as a table.
#pragma once

#include "lutlib/engine/layout.h"
#include "lutlib/interpolation/lattice_reader.h"

#include <array>
#include <span>
#include <string_view>

namespace lutlib {

/// What the engine does with the file's sRGB tag: it wants none (the codes are data), or wants it
/// (and undoes the decoding itself).
enum class SrgbTag { absent, present };

/// What the engine's loader does with what a PNG says of its own colours in the chunks gAMA, cHRM
/// and iCCP: nothing, convert the codes by it, or what is not documented.
enum class ColorChunks { ignored, converted, unknown };

/// What the lookup weighs between nodes: the codes, or the light that its sampler decodes them to
/// by the sRGB curve, which it encodes again.
enum class Filtering { codes, light };

/// Of a lookup whose first and last nodes are the colours 0 and 1: the input of node i of n, and
/// the place of an input among the nodes.
double at_lattice(int i, int n);
double place_at_lattice(double in, int n);

inline constexpr std::array<int, 1> only_8_bits{8};

/// One engine, with what most have in common for defaults. Every lookup takes a colour in
/// codes of 0..1; NaN and -Inf read as 0, +Inf as 1.
struct Engine {
    std::string_view name;
    std::string_view label;
    std::string_view layout; ///< name of a row of layouts()
    int default_size;
    std::span<const int> sizes = {}; ///< lattice sizes the engine accepts; empty: any of its layout
    /// Of those, the ones that work without a setting in the project; empty: all. Nothing else is
    /// chosen unless it was asked for.
    std::span<const int> usual_sizes = {};
    int default_bits = 8;
    std::span<const int> bits = only_8_bits; ///< sample depths the engine accepts
    SrgbTag srgb_tag = SrgbTag::absent;
    ColorChunks color_chunks;
    /// What the code values are that the lookup gets and gives, as of encoding_named(): those of
    /// the display that they go to. Empty: the engine hands on what the look is made for.
    std::string_view encoding = {};
    std::string_view input;  ///< the same in words, and where the lookup stands
    std::string_view import; ///< settings that the engine's importer needs
    std::string_view lookup_help;
    std::string_view source; ///< where the contract and the lookup are documented
    /// The input at which the engine reads node i of n exactly, 0..1.
    double (*node_input)(int i, int n) = at_lattice;
    /// Where the lookup finds an input of 0..1 between the nodes, 0 .. n-1; does not fall.
    double (*place)(double in, int n) = place_at_lattice;
    /// How the lookup weighs the nodes around that place.
    Interpolation interpolation = Interpolation::trilinear;
    Filtering filtering = Filtering::codes;
    /// The engine's arithmetic in float over a picture of codes/maximum; `n` is the lattice size.
    Rgb (*lookup)(const Picture& picture, int n, Rgb in);
    /// The GLSL function that computes the same in the preview (shaders/common/lookup.glsl); empty
    /// where layout, place and interpolation say all.
    std::string_view shader = {};
};

std::span<const Engine> engines();
/// Whether its lookup stands behind the tone map, or anywhere: not on scene light.
bool is_fed_display_codes(const Engine& engine);
/// In letters of any case. Null when there is none.
const Engine* engine_named(std::string_view name);

/// What the engines that read this layout all feed their lookup; empty where they differ, or take
/// what the look is made for.
std::string_view encoding_fed_through(const Layout& layout);

/// How the engine reads a lattice of `size`.
LatticeReader reader_of(const Engine& engine, int size);

} // namespace lutlib
