#include "preview/graph/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace preview {

namespace {

struct AccessInfo {
    Access access;
    bool writes;
    Layout layout;
};

/// In the order of the enumeration.
constexpr AccessInfo accesses[] = {
    {Access::compute_sample, false, Layout::read_only},
    {Access::graphics_sample, false, Layout::read_only},
    {Access::compute_read, false, Layout::undefined},
    {Access::graphics_read, false, Layout::undefined},
    {Access::index_read, false, Layout::undefined},
    {Access::indirect_read, false, Layout::undefined},
    {Access::compute_write, true, Layout::general},
    {Access::color_write, true, Layout::color},
    {Access::depth_write, true, Layout::depth},
    {Access::transfer_read, false, Layout::transfer_src},
    {Access::transfer_write, true, Layout::transfer_dst},
};
static_assert(std::size(accesses) == access_count);

/// What has happened to a resource so far in the frame.
struct State {
    AccessMask last_write = 0;
    AccessMask reads = 0; ///< since the last write; each already waits for it
    Layout layout = Layout::undefined;
};

/// The barrier that `access` needs, if any, and the state after it.
bool advance(State& state, Access access, bool is_image, bool keeps, Barrier& barrier) {
    const bool writes = is_write(access);
    const Layout layout = is_image ? layout_of(access) : Layout::undefined;
    const bool moves = layout != state.layout;
    const bool needed = writes || moves || (state.reads & mask(access)) == 0;
    barrier.from = state.last_write | state.reads;
    barrier.to = mask(access);
    barrier.old_layout = writes && !keeps ? Layout::undefined : state.layout;
    barrier.new_layout = layout;
    if (writes) {
        state.last_write = mask(access);
        state.reads = 0;
    } else {
        state.reads = moves ? mask(access) : state.reads | mask(access);
    }
    state.layout = layout;
    return needed;
}

class Planner {
  public:
    explicit Planner(const Graph& graph) : graph_(graph) {
        plan_.pass_lives.assign(graph.passes().size(), false);
        plan_.version_lives.assign(graph.versions().size(), false);
        plan_.reasons.resize(graph.passes().size());
    }

    Plan run() {
        sweep_backwards();
        sweep_forwards();
        for (std::size_t pass = 0; pass < plan_.reasons.size(); ++pass)
            if (!plan_.pass_lives[pass])
                plan_.reasons[pass] = reason_for(pass);
        return std::move(plan_);
    }

  private:
    void sweep_backwards() {
        for (const std::uint32_t version : graph_.presented())
            plan_.version_lives[version] = true;
        for (std::size_t index = graph_.passes().size(); index-- > 0;) {
            const PassRecord& pass = graph_.passes()[index];
            const bool wanted =
                std::any_of(pass.uses.begin(), pass.uses.end(), [&](const Use& use) {
                    return use.writes && plan_.version_lives[use.version];
                });
            if (!wanted)
                continue;
            plan_.pass_lives[index] = true;
            for (const Use& use : pass.uses) {
                const std::uint32_t read = use.writes && use.version != Version::none
                                               ? graph_.versions()[use.version].previous
                                               : use.version;
                if (read != Version::none)
                    plan_.version_lives[read] = true;
            }
        }
    }

    /// A colour target that nobody reads is no part of its pass.
    bool dropped(const Use& use) const {
        return use.access == Access::color_write && !plan_.version_lives[use.version];
    }

    void sweep_forwards() {
        std::vector<State> states(graph_.resources().size());
        std::vector<std::uint32_t> lifetime_of(graph_.resources().size(), Version::none);
        for (std::uint32_t index = 0; index < graph_.passes().size(); ++index) {
            if (!plan_.pass_lives[index])
                continue;
            const auto step_index = static_cast<std::uint32_t>(plan_.steps.size());
            Step step;
            step.pass = index;
            for (const Use& use : graph_.passes()[index].uses) {
                if (use.version == Version::none || dropped(use))
                    continue;
                const Version& version = graph_.versions()[use.version];
                if (graph_.resource_of(use.version).origin != Origin::transient)
                    continue;
                add_barrier(step, states, use, version);
                if (lifetime_of[version.resource] == Version::none) {
                    lifetime_of[version.resource] =
                        static_cast<std::uint32_t>(plan_.lifetimes.size());
                    plan_.lifetimes.push_back({version.resource, step_index, step_index});
                }
                plan_.lifetimes[lifetime_of[version.resource]].last = step_index;
            }
            plan_.steps.push_back(std::move(step));
        }
        for (const std::uint32_t version : graph_.presented()) {
            const std::uint32_t resource = graph_.versions()[version].resource;
            if (graph_.resource_of(version).origin != Origin::transient)
                continue;
            Presented end;
            end.version = version;
            end.barrier.resource = resource;
            advance(states[resource], Access::transfer_read,
                    graph_.resources()[resource].kind == ResourceKind::image, true, end.barrier);
            plan_.presented.push_back(end);
            plan_.lifetimes[lifetime_of[resource]].last =
                static_cast<std::uint32_t>(plan_.steps.size());
        }
    }

    void add_barrier(Step& step, std::vector<State>& states, const Use& use,
                     const Version& version) const {
        const bool is_image = graph_.resources()[version.resource].kind == ResourceKind::image;
        // The same resource read twice in one pass needs one barrier.
        for (Barrier& barrier : step.barriers)
            if (barrier.resource == version.resource && !use.writes &&
                barrier.new_layout == (is_image ? layout_of(use.access) : Layout::undefined)) {
                barrier.to |= mask(use.access);
                states[version.resource].reads |= mask(use.access);
                return;
            }
        Barrier barrier;
        barrier.resource = version.resource;
        const bool keeps = version.previous != Version::none;
        if (advance(states[version.resource], use.access, is_image, keeps, barrier))
            step.barriers.push_back(barrier);
    }

    std::string reason_for(std::size_t pass) const {
        std::string names;
        for (const Use& use : graph_.passes()[pass].uses)
            if (use.writes)
                names += (names.empty() ? "'" : ", '") + graph_.resource_of(use.version).name + "'";
        return names.empty() ? std::string("it writes nothing")
                             : fmt::format("nothing that is shown reads {}", names);
    }

    const Graph& graph_;
    Plan plan_;
};

} // namespace

Layout layout_of(Access access) {
    return accesses[static_cast<std::size_t>(access)].layout;
}

bool is_write(Access access) {
    return accesses[static_cast<std::size_t>(access)].writes;
}

Plan make_plan(const Graph& graph) {
    return Planner(graph).run();
}

Placement place(std::span<const Lifetime> lifetimes, std::span<const Extent> extents) {
    Placement placement;
    placement.offsets.assign(lifetimes.size(), 0);
    std::vector<std::size_t> order(lifetimes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return extents[a].size > extents[b].size;
    });
    std::vector<std::size_t> placed;
    for (const std::size_t index : order) {
        std::vector<std::size_t> rivals;
        for (const std::size_t other : placed)
            if (lifetimes[other].first <= lifetimes[index].last &&
                lifetimes[index].first <= lifetimes[other].last)
                rivals.push_back(other);
        std::sort(rivals.begin(), rivals.end(), [&](std::size_t a, std::size_t b) {
            return placement.offsets[a] < placement.offsets[b];
        });
        const std::uint64_t alignment = extents[index].alignment;
        std::uint64_t offset = 0;
        for (const std::size_t rival : rivals) {
            if (offset + extents[index].size <= placement.offsets[rival])
                break;
            const std::uint64_t end = placement.offsets[rival] + extents[rival].size;
            offset = std::max(offset, (end + alignment - 1) / alignment * alignment);
        }
        placement.offsets[index] = offset;
        placement.bytes = std::max(placement.bytes, offset + extents[index].size);
        placed.push_back(index);
    }
    return placement;
}

std::string explain(const Graph& graph, const Plan& plan) {
    std::size_t width = 0;
    for (const PassRecord& pass : graph.passes())
        width = std::max(width, pass.name.size());
    for (const Withheld& item : graph.withheld())
        width = std::max(width, item.name.size());
    std::string text;
    for (std::size_t index = 0; index < graph.passes().size(); ++index) {
        const PassRecord& pass = graph.passes()[index];
        std::string outputs;
        for (const Use& use : pass.uses) {
            if (!use.writes)
                continue;
            const Version& version = graph.versions()[use.version];
            const bool lives = plan.version_lives[use.version];
            if (plan.pass_lives[index] && (lives || use.access != Access::color_write))
                outputs +=
                    (outputs.empty() ? "writes " : ", ") + graph.resources()[version.resource].name;
        }
        text += plan.pass_lives[index]
                    ? fmt::format("kept      {:<{}}  {}\n", pass.name, width, outputs)
                    : fmt::format("left out  {:<{}}  {}\n", pass.name, width, plan.reasons[index]);
    }
    for (const Withheld& item : graph.withheld())
        text += fmt::format("left out  {:<{}}  {}\n", item.name, width, item.reason);
    return text;
}

} // namespace preview
