#include "preview/editor/commands.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/look_text.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/recipe_file.h"
#include "preview/editor/look_export.h"

#include <filesystem>
#include <system_error>

namespace preview::editor {

namespace fs = std::filesystem;
namespace io = lutlib::io;

void open_look(State& state, const io::Look& look, const lutlib::LookEncodings& said) {
    State next = state;
    const bool is_recipe = look.recipe() != nullptr;
    next.recipe = look.as_recipe();
    next.recipe.title = look.title();
    next.solo.reset();
    next.saved = next.recipe;
    next.told = told_of(look);
    next.said = said;
    next.recipe_path = is_recipe ? look.path() : "";
    next.base_path = is_recipe ? io::base_path(next.recipe, look.path()) : look.path();
    const auto shows_recipe = [](const Side& side) {
        return side.source == SideSource::recipe || side.source == SideSource::baked;
    };
    if (!shows_recipe(next.sides[0]) && !shows_recipe(next.sides[1])) {
        next.sides[1].source = SideSource::recipe;
    }
    state = std::move(next);
}

void open_kept(State& state, const std::string& path) {
    State next = state;
    next.recipe = lutlib::parse_recipe(io::read_file(path), path);
    next.recipe_path.clear();
    next.base_path = io::base_path(next.recipe, path);
    next.saved = {};
    next.told.clear();
    next.said = {};
    if (!next.base_path.empty()) {
        const io::Look base = io::Look::open(next.base_path);
        next.recipe.base_lut = base.table().lut;
        next.told = told_of(base);
    }
    if (next.sides[0].source != SideSource::recipe) {
        next.sides[1].source = SideSource::recipe;
    }
    state = std::move(next);
}

void open_side(Side& side, const io::Look& look, const lutlib::LookEncodings& said) {
    side.lut = look.table().lut;
    side.path = look.path();
    side.files.clear();
    for (const io::LookFile& file : look.files()) {
        side.files.push_back(file.name);
    }
    side.said = said;
    side.told = told_of(look);
    side.source = SideSource::file;
}

std::string look_name(const State& state) {
    const std::string& path = !state.recipe_path.empty() ? state.recipe_path : state.base_path;
    return path.empty() ? "look" : fs::path(path).stem().string();
}

std::string window_title(const State& state) {
    const std::string& path = !state.recipe_path.empty() ? state.recipe_path : state.base_path;
    return (is_unsaved(state) ? "* " : "") +
           (path.empty() ? "" : fs::path(path).filename().string() + " - ") + "lutpreview";
}

void save_recipe(History& history, const std::string& path) {
    State& state = history.draft();
    io::save_recipe(state.recipe, path, state.base_path);
    state.recipe_path = path;
    history.mark_saved();
}

std::string export_strip(const State& state, const Side& side, const std::string& path) {
    const PreparedExport prepared =
        prepare_strip(state, *side.engine->engine, {side.size, side.bits, {}}, path);
    write(prepared);
    return prepared.report;
}

std::string strip_in(const std::string& folder, const State& state) {
    return (fs::path(folder) / (look_name(state) + ".png")).string();
}

bool is_replaceable(const State& state, const std::string& path) {
    std::error_code unknown;
    if (!fs::exists(fs::symlink_status(path, unknown))) {
        return true;
    }
    return fs::is_regular_file(path, unknown) && !fs::equivalent(path, state.base_path, unknown) &&
           io::is_own_picture(path);
}

} // namespace preview::editor
