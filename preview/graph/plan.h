// What of a graph must run, in which order, with which barriers and in whose memory.
#pragma once

#include "preview/graph/graph.h"

#include <functional>
#include <string>
#include <vector>

namespace preview {

enum class Layout : std::uint8_t {
    undefined,
    general,
    read_only,
    color,
    depth,
    transfer_src,
    transfer_dst
};

/// The layout that an access needs of an image.
Layout layout_of(Access access);
bool is_write(Access access);

/// Before a step: what `from` did must be finished and visible to `to`. An empty `from` is the
/// first use in the frame; its old contents, and those of whoever had the memory, are dropped.
struct Barrier {
    std::uint32_t resource = 0;
    AccessMask from = 0;
    AccessMask to = 0;
    Layout old_layout = Layout::undefined;
    Layout new_layout = Layout::undefined;
    friend bool operator==(const Barrier&, const Barrier&) = default;
};

struct Step {
    std::uint32_t pass = 0;
    std::vector<Barrier> barriers;
};

/// The steps between which a transient's contents matter; both are included. A presented one
/// lasts one step longer than the last.
struct Lifetime {
    std::uint32_t resource = 0;
    std::uint32_t first = 0, last = 0;
};

/// Where a presented resource stands at the end of the frame: readable by a transfer.
struct Presented {
    std::uint32_t version = 0;
    Barrier barrier;
};

struct Plan {
    std::vector<Step> steps;
    std::vector<Lifetime> lifetimes; ///< living transients, by first step
    std::vector<Presented> presented;
    std::vector<bool> pass_lives;
    std::vector<bool> version_lives;  ///< written by a living pass and read by one, or presented
    std::vector<std::string> reasons; ///< of a pass that does not live; else empty
};

/// One reverse sweep from what is presented decides what lives; one forward sweep derives the
/// barriers.
Plan make_plan(const Graph& graph);

struct Extent {
    std::uint64_t size = 0, alignment = 1;
};
struct Placement {
    std::vector<std::uint64_t> offsets; ///< one a lifetime, in order
    std::uint64_t bytes = 0;            ///< of the whole pool
};

/// Places transients in one pool so that those whose lifetimes meet never overlap: largest first,
/// each at the lowest offset that is free throughout its life.
Placement place(std::span<const Lifetime> lifetimes, std::span<const Extent> extents);

/// One line for each pass and each thing withheld: kept or left out, and why.
std::string explain(const Graph& graph, const Plan& plan);

} // namespace preview
