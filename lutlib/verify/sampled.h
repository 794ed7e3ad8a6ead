// Recognises a picture of what a look was sampled from.
#pragma once

#include "lutlib/metrics/breaks.h"
#include "lutlib/verify/diagnose.h"

#include <optional>
#include <string>

namespace lutlib {

/// In words, when the codes agree with the look near its nodes, which are its `breaks`, and differ
/// between them: its interpolation is what is missing in the picture. The squared differences of
/// smooth looks grow with the square of f (1 - f), where f is an input's place between two nodes,
/// summed over the axes; noise and other looks do not know the nodes. Nothing of a look whose nodes
/// are not known, or where those of the engine are the same.
std::optional<std::string> sampling_between_nodes(const CodeImage& picture, const Engine& engine,
                                                  int size, const Transform& look,
                                                  const Breaks& breaks);

} // namespace lutlib
