// What of a graph must run, in which order, with which barriers and in whose memory.
#pragma once

#include "preview/graph/graph.h"

#include <map>
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
/// first use of what nobody has used before, in the frame or, of a persistent resource, ever; its
/// old contents, and those of whoever had the memory, are dropped.
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
    std::uint32_t needed = 0; ///< its place in Plan::needed
    std::vector<Barrier> barriers;
};

/// The places in Plan::needed between which a transient's contents matter; both are included. A
/// presented one lasts one longer than the last.
struct Lifetime {
    std::uint32_t resource = 0;
    std::uint32_t first = 0, last = 0;
};

/// Where a presented resource stands at the end of the frame: readable by a transfer.
struct Presented {
    std::uint32_t version = 0;
    Barrier barrier;
};

/// What has happened to a resource so far: in the frame, or in all frames to one that outlives
/// them.
struct ResourceState {
    AccessMask last_write = 0;
    AccessMask reads = 0; ///< since the last write; each already waits for it
    Layout layout = Layout::undefined;
};

/// A persistent resource between two frames.
struct Held {
    ResourceKind kind = ResourceKind::image;
    ImageDesc image;
    std::uint64_t bytes = 0;
    AccessMask accesses = 0; ///< those it was made for
    std::string fingerprint; ///< of its contents; empty: they are not right for anything
    ResourceState state;
};
using HeldResources = std::map<std::string, Held>; ///< by name

struct Plan {
    /// The passes that what is presented would need if no earlier frame had left anything. The
    /// Vulkan objects of a frame are theirs, so that nothing is rebuilt when a pass begins to rest.
    std::vector<std::uint32_t> needed;
    std::vector<Step> steps;         ///< those of them that run
    std::vector<Lifetime> lifetimes; ///< living transients, by first step
    std::vector<Presented> presented;
    std::vector<bool> pass_lives;     ///< runs
    std::vector<bool> version_lives;  ///< written by a needed pass and read by one, or presented
    std::vector<std::string> reasons; ///< of a pass that does not run; else empty
    HeldResources held;               ///< what this frame leaves; what it did not need is dropped
    std::vector<std::uint32_t> made;  ///< persistent resources that have to be made for this frame
};

/// Reverse sweeps from what is presented decide what runs; one forward sweep derives the barriers.
/// `held` is what the frame before has left.
Plan make_plan(const Graph& graph, const HeldResources& held = {});

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
