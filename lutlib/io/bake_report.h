// What a bake says of itself, in the words that every program uses.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/lut.h"
#include "lutlib/recipe/placement.h"

#include <string>

namespace lutlib::io {

/// "max 0.0123, p99 0.01, p95 0.008, mean 0.002"
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

/// The error of the engine's lookup against the look over a few thousand colours: enough to say how
/// large it is; `lutconv verify` looks at all.
LookupError measure_bake(const Bake& bake, const Transform& look);

/// Lines of text: the picture's shape, the engine's contract, the encodings, what was lost, and the
/// error.
std::string bake_report(const std::string& input, const std::string& output, const Bake& bake,
                        const Domain& domain, const LookPlace& place, const LookupError& error);

} // namespace lutlib::io
