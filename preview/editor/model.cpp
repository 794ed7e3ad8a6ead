#include "preview/editor/model.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace preview::editor {

namespace {

auto values_of(const lutlib::Recipe& r) {
    return std::tie(r.title, r.input, r.output, r.adaptation, r.base, r.base_lut, r.bake,
                    r.operations, r.opacity);
}

auto values_of(const Orbit& o) {
    return std::tie(o.target.x, o.target.y, o.target.z, o.distance, o.azimuth, o.elevation,
                    o.field_of_view, o.near_plane, o.roll, o.pan.x, o.pan.y);
}

auto values_of(const State& s) {
    return std::tie(s.recipe_path, s.base_path, s.sides, s.versions, s.picture, s.shown, s.lights,
                    s.surroundings, s.scopes_seen, s.cube, s.solo);
}

} // namespace

std::string title_of(const Side& side) {
    if (side.source == SideSource::file) {
        return std::filesystem::path(side.path).stem().string();
    }
    if (side.source == SideSource::none) {
        return "no look";
    }
    if (side.source == SideSource::version) {
        return "version " + std::to_string(side.version_place + 1);
    }
    if (side.source == SideSource::still && side.still) {
        return "still " + preview::title_of(*side.still);
    }
    const SideSourceInfo& row = side_sources[static_cast<std::size_t>(side.source)];
    return std::string(row.name) +
           (side.source == SideSource::baked ? " " + std::string(side.engine->name) : "");
}

bool same(const lutlib::Recipe& a, const lutlib::Recipe& b) {
    return values_of(a) == values_of(b);
}

bool operator==(const State& a, const State& b) {
    return values_of(a) == values_of(b) && same(a.recipe, b.recipe) &&
           static_cast<const PictureSettings&>(a) == static_cast<const PictureSettings&>(b) &&
           values_of(a.orbit) == values_of(b.orbit);
}

State initial_state() {
    State state;
    for (Side& side : state.sides) {
        side.engine = engine_lookups().front();
    }
    state.sides[1].source = SideSource::recipe;
    state.compare = &compare_split;
    return state;
}

History::History(State first) : states_{first}, draft_(std::move(first)) {}

void History::mark_saved() {
    change_all([saved = draft_.recipe](State& state) { state.saved = saved; });
}

void History::change_all(const std::function<void(State&)>& change) {
    change(draft_);
    for (State& state : states_) {
        change(state);
    }
}

void History::step_to_draft() {
    states_.insert(states_.begin() + static_cast<std::ptrdiff_t>(++at_), draft_);
    if (states_.size() > max_steps) {
        states_.erase(states_.begin());
        --at_;
    }
}

void History::insert(State next) {
    settle();
    draft_ = std::move(next);
    step_to_draft();
}

bool History::settle() {
    if (draft_ == states_[at_]) {
        return false;
    }
    states_.resize(at_ + 1);
    step_to_draft();
    return true;
}

bool History::undo() {
    settle();
    if (!can_undo()) {
        return false;
    }
    draft_ = states_[--at_];
    return true;
}

bool History::redo() {
    settle();
    if (!can_redo()) {
        return false;
    }
    draft_ = states_[++at_];
    return true;
}

void add_operation(lutlib::Recipe& recipe, const lutlib::Op& op) {
    recipe.operations.push_back(default_operation(op));
}

void remove_operation(lutlib::Recipe& recipe, std::size_t at) {
    recipe.operations.erase(recipe.operations.begin() + static_cast<std::ptrdiff_t>(at));
}

void move_operation(lutlib::Recipe& recipe, std::size_t at, std::size_t to) {
    const auto first = recipe.operations.begin();
    const auto from = static_cast<std::ptrdiff_t>(at);
    const auto onto = static_cast<std::ptrdiff_t>(to);
    if (from < onto) {
        std::rotate(first + from, first + from + 1, first + onto + 1);
    } else {
        std::rotate(first + onto, first + from, first + from + 1);
    }
}

std::vector<const GpuLookup*> engine_lookups() {
    std::vector<const GpuLookup*> rows;
    for (const GpuLookup& lookup : gpu_lookups()) {
        if (lookup.engine != nullptr) {
            rows.push_back(&lookup);
        }
    }
    return rows;
}

} // namespace preview::editor
