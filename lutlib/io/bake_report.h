// What a bake says of itself, in the words that every program uses.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/lut.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/recipe/placement.h"

#include <optional>
#include <string>

namespace lutlib::io {

/// "p99 0.01, mean 0.002, p95 0.008; max 0.0123 at (0, 0.5, 1)"; where a larger error may lie
/// where nobody looked, "largest seen" for "max".
std::string figures_text(const ErrorStats& stats);
/// "0..1", or each channel's where they differ.
std::string domain_text(const Domain& domain);

/// How what an engine feeds meets what a look takes.
struct Reach {
    Domain domain;      ///< the look's
    Domain fed;         ///< what it gets of codes 0..1, in its own encoding
    double reached = 1; ///< the share of the domain that is fed, in the channel that loses most
    double clamped = 0; ///< the share of inputs outside the domain, in the channel with most
};
Reach reach_of(const Domain& domain, const Placement& placement = {});

/// What an engine feeds and shows, where it says, and what a look is made for.
LookPlace place_in(const Engine& engine, const LookEncodings& look, bool convert = true);

/// The breaks of a look among an engine's codes, from those of its own inputs. Where they are
/// converted to other primaries, nothing is known of them.
Breaks placed(const Breaks& look, const Placement& placement);

/// What the codes that come out of a place are shown on: an sRGB display where it is not known.
Viewing viewing_of(const LookPlace& place, double reference_white = reference_white_nits);
/// "srgb, reference white 203 cd/m2 (BT.2408)".
std::string text_of(const Viewing& viewing);

/// Lines of the figures of each measure, with `indent` before each: code values, dE2000, and dE-ITP
/// where the output is HDR.
std::string figures_text(const Difference& error, const Viewing& viewing,
                         const std::string& indent);

/// Lines of text: the picture's shape, the engine's contract, the encodings, what was lost, and the
/// error where it was measured.
std::string bake_report(const std::string& input, const std::string& output, const Bake& bake,
                        const Domain& domain, const LookPlace& place,
                        const std::optional<Difference>& error, const Viewing& viewing);

} // namespace lutlib::io
