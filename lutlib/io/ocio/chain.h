// What the operators at the front of OpenColorIO's chain mean as a look's domain, shaper and cube.
#pragma once

#include "lutlib/io/ocio/transform.h"

#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace lutlib::io {

using Chain = std::vector<OCIO::ConstTransformRcPtr>;

/// The operators of a processor in order, groups taken apart.
Chain chain_of(const OCIO::ConstProcessorRcPtr& processor);
/// The operators from `first` on as one processor.
OCIO::ConstProcessorRcPtr processor_of_chain(const Chain& chain, std::size_t first);

/// out = scale * clamp(in, low, high) + offset, each channel by itself.
struct ChannelMap {
    double scale = 1, offset = 0;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};
using ChannelMaps = std::array<ChannelMap, 3>;

/// Adds an operator behind `maps`. False, and nothing changed, when it is not such a map.
bool append(ChannelMaps& maps, const OCIO::ConstTransformRcPtr& op);

/// Adds a curve (of domain 0..1) whose values lie on a rising line, up to float rounding: readers
/// make such curves of what a file means as a domain. False, and nothing changed, for others.
bool append_straight(ChannelMaps& maps, const Lut1D& curve);

/// The inputs that `maps` takes to 0..1, as floats; nullopt when a clamp cuts into them or a
/// channel is not rising.
std::optional<Domain> domain_of_unit(const ChannelMaps& maps);

/// The inputs that `maps` takes to `values`, where no clamp cuts into them; nullopt where a channel
/// is not rising or has no width.
std::optional<Domain> domain_onto(const ChannelMaps& maps, const Domain& values);

/// What an inverse 1D table takes: the values that the table itself has. nullopt for others.
std::optional<Domain> values_of_inverse(const OCIO::ConstTransformRcPtr& op);

/// A plain table, with domain 0..1; nullopt for inverse, half-float-indexed and hue-preserving
/// ones.
std::optional<Lut1D> curve_of(const OCIO::ConstTransformRcPtr& op);
std::optional<Lut3D> cube_of(const OCIO::ConstTransformRcPtr& op);

/// An affine map of colours, of rows that act on (r, g, b, 1).
struct Affine {
    std::array<std::array<double, 4>, 3> rows;
    bool mixes = false;

    Rgb operator()(Rgb c) const;
};
std::optional<Affine> affine_of(const OCIO::ConstTransformRcPtr& op);

} // namespace lutlib::io
