// A frame with every pass's result read back: what `lutpreview check` looks at.
#pragma once

#include "preview/graph/execute.h"
#include "preview/graph/graph.h"

#include <cstdint>
#include <string>
#include <vector>

namespace preview {

/// What a pass has left in an image, or in a buffer that is known to hold floats.
struct Observed {
    std::string pass;          ///< the last that wrote it
    std::uint32_t order = 0;   ///< that pass's place in the graph
    std::uint32_t version = 0; ///< of the graph
    std::string name;          ///< of the image or buffer
    ImageDesc desc;            ///< a buffer: as many texels of one r32f channel in a row
    std::size_t channels = 1;
    /// Texel after texel, rows from the top, layers one behind the other. Codes of normalised
    /// formats are shares of the largest; empty where the texels are no numbers (r32ui).
    std::vector<float> values;
    std::vector<std::uint32_t> words; ///< of r32ui

    std::size_t texels() const { return values.size() / channels; }
};

/// Renders the graph and reads what every pass that it needs has left. What a later pass of the
/// frame has drawn over is seen with that, and as that pass's.
std::vector<Observed> observe(Executor& executor, const Graph& graph);

/// Texels that hold a NaN or, without one, an infinity in any channel.
struct NonFinite {
    std::uint64_t nan = 0, infinite = 0;
    std::uint64_t all() const { return nan + infinite; }
};
NonFinite non_finite(const Observed& observed);

/// The one that this pass has left; null where none has.
const Observed* left_by(const std::vector<Observed>& all, std::string_view pass);
/// The one that has this version of the graph; null where none has.
const Observed* with_version(const std::vector<Observed>& all, std::uint32_t version);

} // namespace preview
