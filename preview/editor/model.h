// What a person changes in the window, as a value, and its history. No drawing, no GPU.
#pragma once

#include "lutlib/recipe/recipe.h"
#include "preview/finish/picture_settings.h"
#include "preview/finish/scopes.h"
#include "preview/look/cube_view.h"
#include "preview/look/look_file.h"
#include "preview/look/still.h"
#include "preview/scene/scene.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace preview {
struct Shown;
}

namespace preview::editor {

/// What one side of the comparison shows.
enum class SideSource : std::uint8_t { none, source, recipe, baked, file, version, still };

struct SideSourceInfo {
    SideSource source;
    std::string_view name;
    std::string_view help;
};

/// In the order of the enumeration.
inline constexpr std::array<SideSourceInfo, 7> side_sources{{
    {SideSource::none, "none", "no look"},
    {SideSource::source, "source", "the LUT that the recipe starts from"},
    {SideSource::recipe, "recipe", "the recipe itself, as a float table with its error stated"},
    {SideSource::baked, "baked", "the recipe's strip as that engine reads it"},
    {SideSource::file, "file", "another LUT file"},
    {SideSource::version, "version", "the version that was put here, as its recipe"},
    {SideSource::still, "still", "a picture as it is, in place of this one under a look"},
}};

/// A look that was stored.
struct Version {
    lutlib::Recipe recipe;
    std::string base_path;         ///< where its base lies
    std::vector<std::string> told; ///< as State::told
};
inline constexpr std::size_t version_count = 9;

struct Side {
    SideSource source = SideSource::none;
    const GpuLookup* engine = nullptr; ///< of `baked`: a lookup that has an engine
    int size = 0, bits = 0;            ///< of `baked`; 0: the engine's own
    std::string path;                  ///< of `file`
    std::vector<std::string> files;    ///< of `file`: itself and, of a recipe, its base
    lutlib::LookEncodings said;        ///< of `file`: in place of what it says
    std::vector<std::string> told;     ///< of `file`: what its reading lost, guessed or left undone
    std::shared_ptr<const lutlib::Lut> lut;
    std::shared_ptr<const Version> version; ///< of `version`
    std::size_t version_place = 0;          ///< where it was stored
    std::shared_ptr<const Still> still;     ///< of `still`
    friend bool operator==(const Side&, const Side&) = default;
};

/// What people call what a side shows: a file's name, else the source's.
std::string title_of(const Side& side);

/// Which scopes are seen, and how.
struct ScopeChoice {
    std::array<bool, scopes.size()> seen{};
    const ScopeSide* side = &scope_side_shown;
    ScopeRegion region;
    std::optional<bool> logarithmic; ///< empty: each scope's own
    const ScopeGain* gain = &scope_gain_none;
    std::optional<lutlib::Encoding> encoding; ///< of the levels; empty: the codes as they are shown
    float height = 0.34F;                     ///< of the window's
    friend bool operator==(const ScopeChoice&, const ScopeChoice&) = default;
};

/// How the cube of a look's nodes is seen.
struct CubeChoice {
    std::size_t side = 1;
    int per_side = 17; ///< at most so many nodes of an axis
    CubeView view;
    friend bool operator==(const CubeChoice&, const CubeChoice&) = default;
};

/// Everything that undo brings back.
struct State : PictureSettings {
    lutlib::Recipe recipe;
    std::optional<std::size_t> solo; ///< the operator that is shown alone, see solo.h
    std::string recipe_path;         ///< empty: never saved
    std::string base_path;           ///< where the recipe's base lies
    lutlib::LookEncodings said;      ///< in place of what a LUT that was opened says
    lutlib::Recipe saved;            ///< the recipe as its file has it: opened or saved last
    std::vector<std::string> told;   ///< what the reading of the look lost, guessed or left undone
    std::array<Side, 2> sides;
    std::array<std::shared_ptr<const Version>, version_count> versions; ///< null: none
    PictureCodes picture;
    std::shared_ptr<const Shown> shown; ///< the scene or picture
    Orbit orbit;
    std::vector<PointLight> lights; ///< in place of the scene's
    Surroundings surroundings;      ///< likewise
    ScopeChoice scopes_seen;
    CubeChoice cube;
};
bool operator==(const State& a, const State& b);

bool same(const lutlib::Recipe& a, const lutlib::Recipe& b);
inline bool is_unsaved(const State& state) {
    return !same(state.recipe, state.saved);
}

/// An empty recipe on side B, beside no look; engines' rows are the first engine's.
State initial_state();

/// A history of whole states. A gesture changes draft() as often as it likes; settle(), called when
/// nothing is held down, makes one step of all that it changed.
class History {
  public:
    explicit History(State first);

    State& draft() { return draft_; }
    const State& draft() const { return draft_; }
    /// Makes a step when the draft differs; forgets what could be redone. Returns whether it did.
    bool settle();
    /// What is not settled is settled first.
    bool undo();
    bool redo();
    /// A file holds the draft's recipe now: every other state's is unsaved.
    void mark_saved();
    /// Changes what every state, the draft too, has of the world outside: no step.
    void change_all(const std::function<void(State&)>& change);
    /// Makes a step to `next`, and keeps what can be redone behind it. What is not settled is
    /// settled first.
    void insert(State next);
    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < states_.size(); }

    static constexpr std::size_t max_steps = 500;

  private:
    void step_to_draft();

    std::vector<State> states_;
    std::size_t at_ = 0;
    State draft_;
};

// Changes of the list of operators. Positions are of existing operations.
void add_operation(lutlib::Recipe& recipe, const lutlib::Op& op);
void remove_operation(lutlib::Recipe& recipe, std::size_t at);
/// Moves the operation `at` so that it stands at `to`.
void move_operation(lutlib::Recipe& recipe, std::size_t at, std::size_t to);

/// The rows of gpu_lookups() that are an engine's.
std::vector<const GpuLookup*> engine_lookups();

} // namespace preview::editor
