#include "preview/graph/plan.h"

#include "preview/graph/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>

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

/// The barrier that `access` needs, if any, and the state after it.
bool advance(ResourceState& state, Access access, bool is_image, bool keeps, Barrier& barrier) {
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
    Planner(const Graph& graph, const HeldResources& held)
        : graph_(graph), held_(held), rests_(graph.resources().size(), false),
          states_(graph.resources().size()) {
        plan_.reasons.resize(graph.passes().size());
    }

    Plan run() {
        Sweep sweep = sweep_backwards();
        for (std::uint32_t pass = 0; pass < sweep.passes.size(); ++pass) {
            if (sweep.passes[pass]) {
                plan_.needed.push_back(pass);
            }
        }
        plan_.version_lives = std::move(sweep.versions);
        const std::vector<bool> is_needed = std::move(sweep.passes);
        find_persistent();
        plan_.pass_lives = run_or_rest();
        sweep_forwards();
        for (std::size_t pass = 0; pass < plan_.reasons.size(); ++pass) {
            if (!plan_.pass_lives[pass]) {
                plan_.reasons[pass] = reason_for(pass, is_needed[pass]);
            }
        }
        for (auto& [resource, held] : persistent_) {
            held.state = states_[resource];
            plan_.held.emplace(graph_.resources()[resource].name, std::move(held));
        }
        return std::move(plan_);
    }

  private:
    struct Sweep {
        std::vector<bool> passes, versions;
    };

    std::uint32_t resource_of(const Use& use) const {
        return graph_.versions()[use.version].resource;
    }

    /// What is wanted when the resources that rest need no writer.
    Sweep sweep_backwards() const {
        Sweep out{std::vector<bool>(graph_.passes().size(), false),
                  std::vector<bool>(graph_.versions().size(), false)};
        for (const std::uint32_t version : graph_.presented()) {
            out.versions[version] = true;
        }
        for (std::size_t index = graph_.passes().size(); index-- > 0;) {
            const PassRecord& pass = graph_.passes()[index];
            out.passes[index] =
                std::any_of(pass.uses.begin(), pass.uses.end(), [&](const Use& use) {
                    return use.writes && out.versions[use.version] && !rests_[resource_of(use)];
                });
            if (!out.passes[index]) {
                continue;
            }
            for (const Use& use : pass.uses) {
                const std::uint32_t read = use.writes && use.version != Version::none
                                               ? graph_.versions()[use.version].previous
                                               : use.version;
                if (read != Version::none) {
                    out.versions[read] = true;
                }
            }
        }
        return out;
    }

    /// What the needed passes ask of persistent resources, and whose contents are still right.
    void find_persistent() {
        for (const std::uint32_t pass : plan_.needed) {
            for (const Use& use : graph_.passes()[pass].uses) {
                if (use.version != Version::none && !dropped(use)) {
                    ask(use.version, use.access);
                }
            }
        }
        for (const std::uint32_t version : graph_.presented()) {
            ask(version, Access::transfer_read);
        }
        for (auto& [resource, wanted] : persistent_) {
            const std::uint32_t last = last_version(resource);
            if (plan_.version_lives[last]) {
                wanted.fingerprint = fingerprint_of(graph_, last);
            }
            const auto found = held_.find(graph_.resources()[resource].name);
            if (found == held_.end() || !serves(found->second, wanted)) {
                plan_.made.push_back(resource);
                continue;
            }
            wanted.accesses = found->second.accesses;
            states_[resource] = found->second.state;
            rests_[resource] =
                !wanted.fingerprint.empty() && wanted.fingerprint == found->second.fingerprint;
        }
    }

    void ask(std::uint32_t version, Access access) {
        const std::uint32_t index = graph_.versions()[version].resource;
        const Resource& resource = graph_.resources()[index];
        if (resource.origin == Origin::persistent) {
            Held& wanted = persistent_[index];
            wanted.kind = resource.kind;
            wanted.image = resource.image;
            wanted.bytes = resource.bytes;
            // Another frame, which shall find it, may read it in these ways.
            wanted.accesses |= mask(access) | mask(Access::transfer_read) |
                               mask(resource.kind == ResourceKind::image ? Access::compute_sample
                                                                         : Access::compute_read);
        }
    }

    static bool serves(const Held& held, const Held& wanted) {
        return held.kind == wanted.kind && held.image == wanted.image &&
               held.bytes == wanted.bytes && (wanted.accesses & ~held.accesses) == 0;
    }

    std::uint32_t last_version(std::uint32_t resource) const {
        std::uint32_t last = Version::none;
        for (std::uint32_t version = 0; version < graph_.versions().size(); ++version) {
            if (graph_.versions()[version].resource == resource) {
                last = version;
            }
        }
        return last;
    }

    /// The passes that run. One that runs for another of its results writes what could have
    /// rested, and then all that leads to that has to run too.
    std::vector<bool> run_or_rest() {
        for (;;) {
            std::vector<bool> runs = sweep_backwards().passes;
            bool is_settled = true;
            for (std::size_t pass = 0; pass < runs.size(); ++pass) {
                for (const Use& use : graph_.passes()[pass].uses) {
                    if (runs[pass] && use.writes && rests_[resource_of(use)]) {
                        rests_[resource_of(use)] = false;
                        is_settled = false;
                    }
                }
            }
            if (is_settled) {
                return runs;
            }
        }
    }

    /// A colour target that nobody reads is no part of its pass, nor is one of write_if_read().
    bool dropped(const Use& use) const {
        return (use.access == Access::color_write || use.only_if_read) &&
               !plan_.version_lives[use.version];
    }

    void sweep_forwards() {
        lifetime_of_.assign(graph_.resources().size(), Version::none);
        for (std::uint32_t place = 0; place < plan_.needed.size(); ++place) {
            const std::uint32_t index = plan_.needed[place];
            Step step;
            step.pass = index;
            step.needed = place;
            for (const Use& use : graph_.passes()[index].uses) {
                if (use.version == Version::none || dropped(use) ||
                    !graph_.resource_of(use.version).is_written()) {
                    continue;
                }
                lives(resource_of(use), place);
                if (plan_.pass_lives[index]) {
                    add_barrier(step, use);
                }
            }
            if (plan_.pass_lives[index]) {
                plan_.steps.push_back(std::move(step));
            }
        }
        for (const std::uint32_t version : graph_.presented()) {
            const std::uint32_t resource = graph_.versions()[version].resource;
            if (!graph_.resource_of(version).is_written()) {
                continue;
            }
            Presented end;
            end.version = version;
            end.barrier.resource = resource;
            advance(states_[resource], Access::transfer_read,
                    graph_.resources()[resource].kind == ResourceKind::image, true, end.barrier);
            plan_.presented.push_back(end);
            lives(resource, static_cast<std::uint32_t>(plan_.needed.size()));
        }
    }

    void lives(std::uint32_t resource, std::uint32_t place) {
        if (graph_.resources()[resource].origin != Origin::transient) {
            return;
        }
        if (lifetime_of_[resource] == Version::none) {
            lifetime_of_[resource] = static_cast<std::uint32_t>(plan_.lifetimes.size());
            plan_.lifetimes.push_back({resource, place, place});
        }
        plan_.lifetimes[lifetime_of_[resource]].last = place;
    }

    void add_barrier(Step& step, const Use& use) {
        const std::uint32_t resource = resource_of(use);
        const bool is_image = graph_.resources()[resource].kind == ResourceKind::image;
        // The same resource read twice in one pass needs one barrier.
        for (Barrier& barrier : step.barriers) {
            if (barrier.resource == resource && !use.writes &&
                barrier.new_layout == (is_image ? layout_of(use.access) : Layout::undefined)) {
                barrier.to |= mask(use.access);
                states_[resource].reads |= mask(use.access);
                return;
            }
        }
        Barrier barrier;
        barrier.resource = resource;
        const bool keeps = graph_.versions()[use.version].previous != Version::none;
        if (advance(states_[resource], use.access, is_image, keeps, barrier)) {
            step.barriers.push_back(barrier);
        }
    }

    std::string reason_for(std::size_t pass, bool is_needed) const {
        std::string names;
        for (const Use& use : graph_.passes()[pass].uses) {
            if (!use.writes) {
                continue;
            }
            const Resource& resource = graph_.resource_of(use.version);
            if (is_needed && rests_[resource_of(use)]) {
                return "kept from an earlier frame: " + resource.still_right;
            }
            names += (names.empty() ? "'" : ", '") + resource.name + "'";
        }
        if (names.empty()) {
            return "it writes nothing";
        }
        return is_needed ? fmt::format("what reads {} is kept from an earlier frame", names)
                         : fmt::format("nothing that is shown reads {}", names);
    }

    const Graph& graph_;
    const HeldResources& held_;
    Plan plan_;
    std::map<std::uint32_t, Held> persistent_; ///< of the frame, by resource
    std::vector<bool> rests_;                  ///< by resource: its contents are kept as they are
    std::vector<ResourceState> states_;        ///< by resource
    std::vector<std::uint32_t> lifetime_of_;   ///< by resource
};

} // namespace

Layout layout_of(Access access) {
    return accesses[static_cast<std::size_t>(access)].layout;
}

bool is_write(Access access) {
    return accesses[static_cast<std::size_t>(access)].writes;
}

Plan make_plan(const Graph& graph, const HeldResources& held) {
    return Planner(graph, held).run();
}

} // namespace preview
