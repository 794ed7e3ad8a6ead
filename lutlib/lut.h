// Value types: a per-channel curve (Lut1D), a lattice of colours (Lut3D), and a look (Lut).
#pragma once

#include "lutlib/rgb.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lutlib {

/// The input interval of each channel that a table spans. Inputs outside are clamped to it.
struct Domain {
    Rgb min{0, 0, 0};
    Rgb max{1, 1, 1};

    bool is_unit() const { return *this == Domain{}; }
    friend bool operator==(const Domain&, const Domain&) = default;
};

/// Three curves of equal length, evenly spaced over `domain`, interpolated linearly.
struct Lut1D {
    Domain domain;
    std::vector<Rgb> entries;

    int size() const { return static_cast<int>(entries.size()); }
    friend bool operator==(const Lut1D&, const Lut1D&) = default;
};

/// size^3 colours, evenly spaced over `domain` in each channel, red fastest:
/// index = r + size * (g + size * b).
struct Lut3D {
    Domain domain;
    int size = 0;
    std::vector<Rgb> nodes;

    std::size_t index(int r, int g, int b) const {
        const auto n = static_cast<std::size_t>(size);
        return static_cast<std::size_t>(r) +
               n * (static_cast<std::size_t>(g) + n * static_cast<std::size_t>(b));
    }
    const Rgb& at(int r, int g, int b) const { return nodes[index(r, g, b)]; }
    Rgb& at(int r, int g, int b) { return nodes[index(r, g, b)]; }
    friend bool operator==(const Lut3D&, const Lut3D&) = default;
};

/// How a cube is read between its nodes.
enum class Interpolation { nearest, trilinear, tetrahedral };

/// What a look's code values are, before it and after it: names as of encoding_named(), such as
/// "slog3/sgamut3.cine"; empty where it is not known.
struct EncodingNames {
    std::string input, output;

    bool any() const { return !input.empty() || !output.empty(); }
    friend bool operator==(const EncodingNames&, const EncodingNames&) = default;
};

/// A look: first the shaper, then the cube. At least one of the two is present in anything read
/// from a file; with neither, the look is the identity.
struct Lut {
    std::optional<Lut1D> shaper;
    std::optional<Lut3D> cube;
    /// What the file asks the cube to be read by. Unset, as in most formats: tetrahedral.
    std::optional<Interpolation> interpolation;
    std::string title;
    /// As the file says, known to encoding_named() or not.
    EncodingNames encodings;
    /// Comment lines of the file, without their marker, in order.
    std::vector<std::string> comments;
    /// Lines of a .cube whose keyword is none of ours, such as LUT_IN_VIDEO_RANGE: kept as they
    /// are, not acted on.
    std::vector<std::string> keywords;
    /// What whoever uses the look must know of how the file was read, a sentence each: a guess and
    /// its reason. Not stored in files.
    std::vector<std::string> notes;
    /// Where the look came from: a file name or a description. Not stored in files.
    std::string provenance;

    /// The inputs that the look tells apart: the shaper's domain, else the cube's.
    const Domain& domain() const;
};

/// The input colour of node (r,g,b): min + i/(size-1) * (max-min), computed in double.
RgbD node_position(const Lut3D& cube, int r, int g, int b);
RgbD entry_position(const Lut1D& curve, int i);

/// A cube whose nodes are their own positions. Throws Error for a size outside limits.h.
Lut3D identity_cube(int size, const Domain& domain = {});

/// Sizes, domains (finite, min < max, finite width) and values (finite) hold; else throws Error.
void validate(const Lut& lut);

/// Throws Error unless `size` is a lattice size that limits.h allows.
void check_cube_size(long long size);
/// Throws Error unless `size` is a curve length that limits.h allows.
void check_shaper_size(long long size);
/// Throws Error unless each channel's minimum lies below its maximum by a finite, nonzero width.
void check_domain(const Domain& domain);

} // namespace lutlib
