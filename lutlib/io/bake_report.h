// What a bake says of itself, in the words that every program uses.
#pragma once

#include "lutlib/bake/bake.h"
#include "lutlib/lut.h"

#include <string>

namespace lutlib::io {

/// "max 0.0123, p99 0.01, p95 0.008, mean 0.002"
std::string figures_text(const ErrorStats& stats);
/// "0..1", or each channel's where they differ.
std::string domain_text(const Domain& domain);

/// The share of the look's input domain that 0..1 reaches, in the channel that loses most.
double reachable_share(const Domain& domain);
/// The share of the engine's inputs 0..1 that lie outside the look's domain and are clamped to it.
double clamped_share(const Domain& domain);

/// The error of the engine's lookup against the look over a few thousand colours: enough to say how
/// large it is; `lutconv verify` looks at all.
LookupError measure_bake(const Bake& bake, const Transform& look);

/// Lines of text: the picture's shape, the engine's contract, what was lost, and the error.
std::string bake_report(const std::string& input, const std::string& output, const Bake& bake,
                        const Domain& domain, const LookupError& error);

} // namespace lutlib::io
